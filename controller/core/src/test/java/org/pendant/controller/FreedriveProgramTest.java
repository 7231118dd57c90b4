package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.ProgramState;

/** Programs that let the arm be guided. */
final class FreedriveProgramTest {
  private final RunningProgram running = new RunningProgram();

  private void attach(double massKg) {
    running.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(massKg, 0, 0, 0.05))));
    running.advance(1000);
  }

  private boolean guided() {
    return running.state().freedrive().heldBy(FreedriveHolder.PROGRAM);
  }

  private Joints position() {
    return running.state().arm().actualPositionRad();
  }

  private void push(double fy) {
    running.done(new WorldCommand.PushTool(new Wrench(0, fy, 0, 0, 0, 0)));
  }

  @Test
  void aMoveAfterwardsStartsWhereTheArmHasBeenLeft() {
    running.start(
        """
        freedrive_mode()
        sleep(2)
        end_freedrive_mode()
        q = get_target_joint_positions()
        a = get_actual_joint_positions()
        textmsg(norm(q - a) < 0.0001)
        movej([q[0] + 0.1, q[1], q[2], q[3], q[4], q[5]])
        textmsg("there")
        """);
    running.advance(50);
    Joints start = position();
    push(30);
    running.advance(400);
    push(0);
    running.finish();
    assertEquals(List.of("True", "there"), running.said(), () -> running.reported().toString());
    assertTrue(position().maxAbsDifference(start) > 0.15);
    assertEquals(SafetyMode.NORMAL, running.state().safety().safetyMode());
  }

  @Test
  void aMoveDuringFreedriveEndsTheProgram() {
    running.run("freedrive_mode()\nmovej([1, -1.57, -1.57, -1.57, 1.57, 0])\n");
    assertTrue(
        running.reported().stream()
            .anyMatch(each -> each.contains("movej: the arm is in freedrive, which must be ended")),
        () -> running.reported().toString());
    assertFalse(guided());
  }

  @Test
  void theEndOfTheProgramEndsIt() {
    running.run("teach_mode()\nsleep(0.2)\n");
    assertFalse(guided());
    push(30);
    Joints before = position();
    running.advance(500);
    assertTrue(position().maxAbsDifference(before) < 5e-3);
  }

  @Test
  void aPauseEndsItAndTheProgramGoesOnWithout() {
    running.start("freedrive_mode()\nsleep(1)\ntextmsg(\"on\")\nsleep(1)\n");
    running.advance(100);
    assertTrue(guided());
    running.done(new ProgramCommand.PauseProgram());
    assertFalse(guided());
    running.done(new ProgramCommand.ResumeProgram());
    running.advance(200);
    assertFalse(guided());
    running.finish();
    assertEquals(List.of("on"), running.said());
  }

  @Test
  void aStopEndsIt() {
    running.start("freedrive_mode()\nsleep(100)\n");
    running.advance(100);
    push(30);
    running.advance(200);
    running.done(new ProgramCommand.StopProgram());
    assertFalse(guided());
    push(0);
    running.advance(500);
    Joints rests = position();
    running.advance(500);
    assertTrue(position().maxAbsDifference(rests) < 1e-4);
  }

  @Test
  void aWrongPayloadIsAProtectiveStop() {
    attach(2);
    running.start("freedrive_mode()\ntextmsg(\"on\")\n");
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    String message = running.state().safety().stop().orElseThrow().message();
    assertTrue(message.startsWith("C155A0"), message);
    assertTrue(message.contains("19.64 N, limit 7.365 N"), message);
    assertFalse(guided());
    assertEquals(List.of(), running.said());
  }

  @Test
  void aWrongPayloadThatNobodyChecksMakesTheArmDrift() {
    attach(2);
    running.start("freedrive_mode_no_incorrect_payload_check()\nsleep(100)\n");
    running.advance(50);
    double z = running.state().arm().actualTcpInBase().z();
    running.advance(400);
    assertTrue(guided());
    assertTrue(running.state().arm().actualTcpInBase().z() < z - 0.1);
  }

  @Test
  void aPayloadThatBecomesWrongDuringFreedriveIsAProtectiveStop() {
    attach(2);
    running.start(
        """
        set_target_payload(2, [0, 0, 0.05])
        sleep(0.5)
        freedrive_mode()
        sleep(0.1)
        textmsg("free")
        set_target_payload(0, [0, 0, 0])
        sleep(1)
        textmsg("on")
        """);
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    assertEquals(List.of("free"), running.said());
    assertTrue(
        running.state().safety().stop().orElseThrow().message().startsWith("C155A0"),
        () -> running.reported().toString());
  }

  @Test
  void anotherThreadsMoveKeepsTheArmFromBeingGuided() {
    running.run(
        """
        thread mover():
          movej([1, -1.57, -1.57, -1.57, 1.57, 0])
        end
        run mover()
        sleep(0.1)
        freedrive_mode()
        """);
    assertTrue(
        running.reported().stream()
            .anyMatch(each -> each.contains("freedrive_mode: another thread controls the robot")),
        () -> running.reported().toString());
  }
}
