package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BaseLight;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/** Power, brakes and everything that stops the arm, as commands and snapshots show it. */
final class StopsTest {
  private static final long LONG = 20_000;
  private static final int UNLOCK_FRAMES = 2600;
  private static final String TURN =
      """
      def turn():
        movej([1.5, -1.57, -1.57, -1.57, 1.57, 0], a=1, v=1)
        textmsg("there")
      end
      """;

  private Controller controller = new Controller(ControllerOptions.headless());

  private Reply ask(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    return reply.join();
  }

  private void done(Command command) {
    assertEquals(new Reply.Done(), ask(command));
  }

  private String refusal(Command command) {
    return assertInstanceOf(Reply.Refused.class, ask(command)).refusal().text();
  }

  private void start(String text) {
    Program program = TestController.program(controller, text);
    done(new ProgramCommand.StartProgram(program));
  }

  private void until(BooleanSupplier condition) {
    assertTrue(controller.runUntil(condition, LONG), () -> "never: " + safety());
  }

  private void frames(int count) {
    controller.runUntil(() -> false, count);
  }

  private ControllerState state() {
    return controller.state();
  }

  private SafetyStatus safety() {
    return state().safety();
  }

  private boolean fullSpeed() {
    return state().arm().targetSpeedRadPerS().get(0) >= 0.999;
  }

  private boolean resting() {
    return state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
  }

  private List<String> said() {
    List<String> texts = new ArrayList<>();
    controller.logSince(0).forEach(entry -> texts.add(entry.text()));
    return texts;
  }

  @Test
  void theArmGoesFromPoweredOffToRunningAndBack() {
    controller = new Controller(ControllerOptions.headless().withPower(false));
    controller.advance();
    assertEquals(RobotMode.POWER_OFF, safety().robotMode());
    String refused =
        refusal(new ProgramCommand.StartProgram(TestController.program(controller, TURN)));
    assertTrue(refused.contains("power"), refused);
    done(new SafetyCommand.PowerOn());
    List<RobotMode> seen = new ArrayList<>();
    until(
        () -> {
          if (seen.isEmpty() || seen.getLast() != safety().robotMode()) {
            seen.add(safety().robotMode());
          }
          return safety().robotMode() == RobotMode.IDLE;
        });
    assertEquals(List.of(RobotMode.BOOTING, RobotMode.POWER_ON, RobotMode.IDLE), seen);
    done(new SafetyCommand.ReleaseBrakes());
    until(() -> safety().robotMode() == RobotMode.RUNNING);
    start(TURN);
    until(() -> state().program().ending().isPresent());
    done(new SafetyCommand.PowerOff());
    assertEquals(RobotMode.POWER_OFF, safety().robotMode());
    assertEquals(Joints.ZERO, state().readings().currentA());
  }

  @Test
  void aProtectiveStopPausesOnThePathAndTheProgramGoesOnAfterUnlocking() {
    start(
        """
        def p():
          thread guard():
            sleep(1)
            protective_stop()
          end
          g = run guard()
          movej([1.5, -1.57, -1.57, -1.57, 1.57, 0], a=1, v=1)
          textmsg("there")
        end
        """);
    until(() -> safety().safetyMode() == SafetyMode.PROTECTIVE_STOP);
    until(this::resting);
    assertEquals(ProgramState.PAUSED, state().program().state());
    double where = state().arm().targetPositionRad().get(0);
    assertTrue(where > 0.4 && where < 0.7, "rests on its way at " + where);
    assertTrue(refusal(new ProgramCommand.ResumeProgram()).contains("protective stop"));
    assertTrue(refusal(new SafetyCommand.UnlockProtectiveStop(false)).contains(" s"));
    frames(UNLOCK_FRAMES);
    done(new SafetyCommand.UnlockProtectiveStop(false));
    assertEquals(SafetyMode.NORMAL, safety().safetyMode());
    assertEquals(ProgramState.PAUSED, state().program().state());
    done(new ProgramCommand.ResumeProgram());
    until(() -> state().program().ending().isPresent());
    assertInstanceOf(Ending.Finished.class, state().program().ending().get());
    assertTrue(said().contains("there"));
    assertEquals(1.5, state().arm().targetPositionRad().get(0));
  }

  @Test
  void aSafeguardStopHoldsTheProgramAsLongAsItsInput() {
    start(TURN);
    until(this::fullSpeed);
    done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    assertEquals(SafetyMode.SAFEGUARD_STOP, safety().safetyMode());
    until(this::resting);
    frames(500);
    assertEquals(ProgramState.PAUSED, state().program().state());
    assertEquals(RobotMode.RUNNING, safety().robotMode());
    done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    until(() -> state().program().ending().isPresent());
    assertTrue(said().contains("there"));
  }

  @Test
  void anEmergencyStopBringsTheArmToRestOnItsPathAndTakesThePower() {
    start(TURN);
    until(this::fullSpeed);
    done(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, safety().safetyMode());
    assertEquals(RobotMode.RUNNING, safety().robotMode(), "still stopping under power");
    double begin = state().arm().targetPositionRad().get(0);
    until(() -> safety().robotMode() == RobotMode.POWER_OFF);
    double travelled = state().arm().targetPositionRad().get(0) - begin;
    assertTrue(travelled > 0.02 && travelled < 0.05, "stops within " + travelled + " rad");
    assertInstanceOf(Ending.Stopped.class, state().program().ending().orElseThrow());
    frames(1); // the drives lag behind: the brakes take what is left
    Joints resting = state().arm().actualPositionRad();
    frames(100);
    assertEquals(resting, state().arm().actualPositionRad());
    assertTrue(refusal(new SafetyCommand.PowerOn()).contains("emergency"));
    done(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, false));
    done(new SafetyCommand.PowerOn());
  }

  @Test
  void anArmThatHitsATableStopsWithTheJointTheTimeAndTheTorque() {
    controller =
        new Controller(
            ControllerOptions.headless()
                .withScene(
                    new Scene(
                        List.of(
                            new SceneObject.Plane(
                                "table",
                                new Vector3(0, 0, 0.3),
                                new Vector3(0, 0, 1),
                                Material.DEFAULT)),
                        Optional.empty(),
                        List.of())));
    start(
        """
        def press():
          p = get_actual_tcp_pose()
          movel(pose_add(p, p[0, 0, -0.35, 0, 0, 0]), a=0.5, v=0.1)
        end
        """);
    until(() -> safety().stop().isPresent());
    SafetyStop stop = safety().stop().get();
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety().safetyMode());
    assertTrue(stop.code() == 157 || stop.code() == 153, stop.message());
    assertTrue(stop.joint().isPresent());
    assertTrue(Math.abs(stop.value()) > stop.limit(), stop.message());
    assertTrue(stop.message().contains("C" + stop.code() + "A"), stop.message());
    frames(500);
    assertTrue(
        state().readings().flangeWrenchInBase().fz() < 400,
        "does not keep pressing: " + state().readings().flangeWrenchInBase());
  }

  @Test
  void aPushAtTheToolShowsAsForceAndEndsWithIt() {
    done(new WorldCommand.PushTool(new Wrench(0, 0, -30, 0, 0, 0)));
    frames(500);
    assertEquals(-30, state().readings().flangeWrenchInBase().fz(), 0.5);
    assertEquals(0, state().readings().flangeWrenchInBase().fx(), 0.5);
    done(new WorldCommand.PushTool(Wrench.ZERO));
    frames(500);
    assertEquals(0, state().readings().flangeWrenchInBase().fz(), 0.1);
    assertEquals(
        0,
        state().arm().actualPositionRad().maxAbsDifference(state().arm().targetPositionRad()),
        1e-4);
  }

  @Test
  void aLoadThatNobodyDeclaredHangsOnTheForceSensor() {
    done(new WorldCommand.AttachLoad(Optional.of(Payload.of(2, 0, 0, 0.05))));
    frames(1000);
    assertEquals(-2 * 9.82, state().readings().flangeWrenchInBase().fz(), 0.01 * 2 * 9.82);
    start("def p():\n set_target_payload(2, [0, 0, 0.05])\nend\n");
    frames(500);
    assertEquals(0, state().readings().flangeWrenchInBase().fz(), 0.1);
    done(new WorldCommand.AttachLoad(Optional.empty()));
    frames(1000);
    assertEquals(0, state().readings().flangeWrenchInBase().fz(), 0.1);
  }

  @Test
  void inReducedModeTheToolKeepsToTheReducedSpeed() {
    done(new SafetyCommand.SetSafetyInput(SafetyInput.REDUCED_MODE, true));
    frames(400);
    assertEquals(SafetyMode.REDUCED, safety().safetyMode());
    start("def p():\n movej([1.5, -1.57, -1.57, -1.57, 1.57, 0], a=3, v=3)\nend\n");
    double fastest = 0;
    while (state().program().ending().isEmpty()) {
      controller.advance();
      Joints q = state().arm().targetPositionRad();
      fastest = Math.max(fastest, speedOfTcp(q, state().arm().targetSpeedRadPerS()));
    }
    assertInstanceOf(Ending.Finished.class, state().program().ending().get());
    assertTrue(fastest < 0.75 && fastest > 0.5, "at " + fastest + " m/s");
  }

  private double speedOfTcp(Joints q, Joints qd) {
    double step = 1e-6;
    double[] moved = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      moved[i] = q.get(i) + step * qd.get(i);
    }
    var here = state().arm().kinematics().flangePose(q);
    var there = state().arm().kinematics().flangePose(Joints.of(moved));
    return Math.hypot(Math.hypot(there.x() - here.x(), there.y() - here.y()), there.z() - here.z())
        / step;
  }

  @Test
  void aBackdrivenArmFollowsTheHandAndProgramsWait() {
    controller = new Controller(ControllerOptions.headless().withPower(false));
    controller.advance();
    done(new SafetyCommand.PowerOn());
    until(() -> safety().robotMode() == RobotMode.IDLE);
    done(new SafetyCommand.StartBackdrive());
    until(() -> safety().robotMode() == RobotMode.BACKDRIVE);
    Joints before = state().arm().actualPositionRad();
    frames(500);
    assertEquals(0, before.maxAbsDifference(state().arm().actualPositionRad()), 1e-3, "holds");
    done(new WorldCommand.PushTool(new Wrench(0, 40, 0, 0, 0, 0)));
    frames(500);
    assertTrue(before.maxAbsDifference(state().arm().actualPositionRad()) > 0.01, "moves");
    done(new WorldCommand.PushTool(Wrench.ZERO));
    done(new SafetyCommand.EndBackdrive());
    until(() -> safety().robotMode() == RobotMode.IDLE);
  }

  @Test
  void powerdownEndsTheProgramAndSwitchesTheControllerOff() {
    start("def p():\n powerdown()\n textmsg(\"never\")\nend\n");
    until(() -> safety().shutDown());
    assertEquals(RobotMode.POWER_OFF, safety().robotMode());
    frames(10);
    assertFalse(said().contains("never"));
    assertEquals(BaseLight.STANDARD, safety().baseLight());
  }
}
