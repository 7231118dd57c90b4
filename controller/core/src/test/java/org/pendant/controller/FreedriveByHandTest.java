package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;

/** An operator at the screen guides the arm. */
final class FreedriveByHandTest {
  private static final String WAITING = "def waiting():\n  sleep(100)\nend\n";

  private GuidedArm guided = GuidedArm.free();

  @ParameterizedTest
  @EnumSource
  void thePushedToolMovesAndStopsWhenTheHandIsGone(ArmChoice choice) {
    guided =
        new GuidedArm(
            ControllerOptions.headless().withArm(choice), FreeAxes.ALL, FreedriveFrame.BASE);
    guided.guide(0.2);
    Pose start = guided.tcp();
    guided.push(20, 0, 0);
    guided.guide(1);
    double moved = guided.tcp().x() - start.x();
    assertTrue(moved > 0.03 && moved < 1, "moved by " + moved);
    guided.push(0, 0, 0);
    guided.guide(1);
    Joints rests = guided.position();
    guided.guide(0.5);
    assertEquals(rests, guided.position());
    assertEquals(Joints.ZERO, guided.arm().actualSpeedRadPerS());
    assertEquals(Optional.empty(), guided.state().safety().stop());
  }

  @ParameterizedTest
  @EnumSource
  void theTargetIsWhereTheArmIs(ArmChoice choice) {
    guided =
        new GuidedArm(
            ControllerOptions.headless().withArm(choice), FreeAxes.ALL, FreedriveFrame.BASE);
    guided.guide(0.1);
    guided.push(0, 30, 0);
    guided.guide(
        0.5,
        () -> {
          assertEquals(guided.position(), guided.arm().targetPositionRad());
          assertFalse(guided.arm().steady());
        });
  }

  @ParameterizedTest
  @EnumSource
  void theArmIsHeldWhereFreedriveEnds(ArmChoice choice) {
    guided =
        new GuidedArm(
            ControllerOptions.headless().withArm(choice), FreeAxes.ALL, FreedriveFrame.BASE);
    guided.guide(0.1);
    guided.push(0, 30, 0);
    guided.guide(1);
    guided.push(0, 0, 0);
    guided.guide(1);
    Joints here = guided.position();
    guided.end();
    guided.frames(1000);
    assertTrue(guided.position().maxAbsDifference(here) < 1e-4);
    guided.push(0, 30, 0);
    guided.frames(1000);
    assertTrue(guided.position().maxAbsDifference(here) < 5e-3, "the drives hold again");
  }

  @Test
  void anArmThatMovesComesToRestSoonWithoutAnyStop() {
    guided.guide(0.1);
    guided.push(0, 0, 30);
    guided.guide(0.5);
    double speed = guided.arm().actualSpeedRadPerS().maxAbsDifference(Joints.ZERO);
    assertTrue(speed > 0.3, "turns at " + speed);
    guided.push(0, 0, 0);
    guided.end();
    guided.frames(500);
    Joints rests = guided.position();
    assertTrue(rests.maxAbsDifference(guided.arm().targetPositionRad()) < 1e-4);
    guided.frames(500);
    assertTrue(guided.position().maxAbsDifference(rests) < 1e-4);
    assertEquals(SafetyMode.NORMAL, guided.state().safety().safetyMode());
  }

  @Test
  void aHandThatIsNotHeardOfForAQuarterOfASecondHasLetGo() {
    guided.guide(0.1);
    assertTrue(guided.state().freedrive().heldBy(FreedriveHolder.HAND));
    guided.frames(100);
    assertTrue(guided.state().freedrive().active());
    guided.frames(50);
    assertFalse(guided.state().freedrive().active());
  }

  @Test
  void aProgramHasTheArmForItself() {
    guided.done(
        new ProgramCommand.StartProgram(TestController.program(guided.controller, WAITING)));
    assertEquals(
        new Reply.Refused(
            Refusal.Code.PROGRAM, "program waiting runs, stop it before the arm is guided by hand"),
        guided.hold());
    guided.done(new ProgramCommand.PauseProgram());
    assertEquals(
        new Reply.Refused(
            Refusal.Code.PROGRAM,
            "program waiting is paused, stop it before the arm is guided by hand"),
        guided.hold());
  }

  @Test
  void aProgramThatStartsEndsIt() {
    guided.guide(0.1);
    guided.done(
        new ProgramCommand.StartProgram(TestController.program(guided.controller, WAITING)));
    assertFalse(guided.state().freedrive().active());
  }

  @Test
  void nothingElseMovesTheArmMeanwhile() {
    guided.guide(0.1);
    assertEquals(
        "the arm is in freedrive, which must be ended first",
        guided.refusal(new ManualCommand.Jog(new JogMove.TurnJoint(0, 1), 0.5)));
  }

  @Test
  void theNewestWishCountsWhileTheArmIsJogged() {
    guided.done(new ManualCommand.Jog(new JogMove.TurnJoint(0, 1), 1));
    guided.frames(100);
    guided.hold();
    assertTrue(guided.state().freedrive().active(), guided.said()::toString);
  }

  @Test
  void anEmergencyStopEndsItAndItDoesNotBeginAnewByItself() {
    guided.guide(0.1);
    guided.push(0, 20, 0);
    guided.guide(0.4);
    guided.done(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertFalse(guided.state().freedrive().active());
    guided.frames(100);
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(refused.refusal().text().contains("emergency_stop"), refused.refusal().text());
  }

  @Test
  void aSafeguardStopEndsItUntilItIsLetGoAndAskedForAnew() {
    guided.guide(0.1);
    guided.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(refused.refusal().text().contains("safeguard_stop"), refused.refusal().text());
    guided.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    guided.frames(5);
    assertTrue(guided.hold() instanceof Reply.Refused, "still held");
    guided.end();
    guided.guide(0.1);
    assertTrue(guided.state().freedrive().active());
  }

  @Test
  void powerOffEndsIt() {
    guided.guide(0.1);
    guided.push(0, 20, 0);
    guided.guide(0.4);
    guided.done(new SafetyCommand.PowerOff());
    guided.frames(200);
    assertFalse(guided.state().freedrive().active());
    assertEquals(guided.position(), guided.arm().targetPositionRad());
    assertEquals(Joints.ZERO, guided.arm().actualSpeedRadPerS());
  }

  @Test
  void aWrongPayloadIsRefusedWithWhatIsWrong() {
    guided.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(2, 0, 0, 0.05))));
    guided.frames(1000);
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(
        refused
            .refusal()
            .text()
            .startsWith("the declared payload is wrong by 19.6 N, must be at most 7.4 N"),
        refused.refusal().text());
    assertFalse(guided.state().freedrive().active());
    guided.end();
    guided.done(new ManualCommand.DeclarePayload(2, new Vector3(0, 0, 0.05), Optional.empty()));
    guided.frames(500);
    guided.guide(0.1);
    assertTrue(guided.state().freedrive().active());
  }

  @Test
  void aPayloadThatIsALittleWrongMakesTheArmSink() {
    guided.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(0.7, 0, 0, 0.05))));
    guided.frames(1000);
    Pose start = guided.tcp();
    guided.guide(2);
    assertTrue(guided.tcp().z() < start.z() - 0.05, "sank by " + (start.z() - guided.tcp().z()));
  }

  @Test
  void withTheRightPayloadItStaysWhereItIs() {
    guided.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(3, 0, 0, 0.05))));
    guided.done(new ManualCommand.DeclarePayload(3, new Vector3(0, 0, 0.05), Optional.empty()));
    guided.frames(1000);
    Pose start = guided.tcp();
    guided.guide(2);
    assertTrue(guided.distance(start) < 1e-4, "moved by " + guided.distance(start));
  }

  @Test
  void anInputCanAskForIt() {
    guided.done(
        new ProgramCommand.RunSecondary(
            TestController.program(
                guided.controller,
                "sec s():\n  set_standard_digital_input_action(3, \"freedrive\")\nend\n")));
    guided.done(new IoCommand.SetInput("digital_in[3]", true));
    guided.frames(1);
    assertTrue(guided.state().freedrive().heldBy(FreedriveHolder.INPUT));
    guided.frames(1000);
    assertTrue(guided.state().freedrive().active(), "as long as it is high");
    guided.done(new IoCommand.SetInput("digital_in[3]", false));
    guided.frames(1);
    assertFalse(guided.state().freedrive().active());
  }

  @Test
  void anInputCannotTakeTheArmFromAProgram() {
    guided.done(
        new ProgramCommand.StartProgram(
            TestController.program(
                guided.controller,
                """
                def p():
                  set_standard_digital_input_action(3, "freedrive")
                  sleep(100)
                end
                """)));
    guided.done(new IoCommand.SetInput("digital_in[3]", true));
    guided.frames(10);
    assertFalse(guided.state().freedrive().active());
    assertEquals(
        1,
        guided.said().stream()
            .filter(
                "freedrive by an input: program p runs, stop it before an input asks for freedrive"
                    ::equals)
            .count());
  }
}
