package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Vector3;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.script.vm.Program;

/** Somebody at the screen guides the arm. */
final class FreedriveByHandTest {
  private static final String WAITING = "def waiting():\n  sleep(100)\nend\n";

  private GuidedArm guided = GuidedArm.free();

  private Program program(String text) {
    return guided
        .controller
        .load(Source.of("test.script", text.getBytes(StandardCharsets.ISO_8859_1)))
        .program()
        .orElseThrow();
  }

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
    guided.done(new Command.StartProgram(program(WAITING)));
    assertEquals(
        new Reply.Refused("program waiting runs, stop it before the arm is guided by hand"),
        guided.hold());
    guided.done(new Command.PauseProgram());
    assertEquals(
        new Reply.Refused("program waiting is paused, stop it before the arm is guided by hand"),
        guided.hold());
  }

  @Test
  void aProgramThatStartsEndsIt() {
    guided.guide(0.1);
    guided.done(new Command.StartProgram(program(WAITING)));
    assertFalse(guided.state().freedrive().active());
  }

  @Test
  void nothingElseMovesTheArmMeanwhile() {
    guided.guide(0.1);
    assertEquals(
        "the arm is in freedrive, which must be ended first",
        guided.refusal(new Command.Jog(new JogMove.TurnJoint(0, 1), 0.5)));
  }

  @Test
  void theNewestWishCountsWhileTheArmIsJogged() {
    guided.done(new Command.Jog(new JogMove.TurnJoint(0, 1), 1));
    guided.frames(100);
    guided.hold();
    assertTrue(guided.state().freedrive().active(), guided.said()::toString);
  }

  @Test
  void anEmergencyStopEndsItAndItDoesNotBeginAnewByItself() {
    guided.guide(0.1);
    guided.push(0, 20, 0);
    guided.guide(0.4);
    guided.done(new Command.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertFalse(guided.state().freedrive().active());
    guided.frames(100);
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(refused.reason().contains("emergency_stop"), refused.reason());
  }

  @Test
  void aSafeguardStopEndsItUntilItIsLetGoAndAskedForAnew() {
    guided.guide(0.1);
    guided.done(new Command.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(refused.reason().contains("safeguard_stop"), refused.reason());
    guided.done(new Command.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
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
    guided.done(new Command.PowerOff());
    guided.frames(200);
    assertFalse(guided.state().freedrive().active());
    assertEquals(guided.position(), guided.arm().targetPositionRad());
    assertEquals(Joints.ZERO, guided.arm().actualSpeedRadPerS());
  }

  @Test
  void aWrongPayloadIsRefusedWithWhatIsWrong() {
    guided.done(new Command.AttachLoad(Optional.of(Payload.of(2, 0, 0, 0.05))));
    guided.frames(1000);
    Reply.Refused refused = (Reply.Refused) guided.hold();
    assertTrue(
        refused
            .reason()
            .startsWith("the declared payload is wrong by 19.6 N, must be at most 7.4 N"),
        refused.reason());
    assertFalse(guided.state().freedrive().active());
    guided.end();
    guided.done(new Command.DeclarePayload(2, new Vector3(0, 0, 0.05), Optional.empty()));
    guided.frames(500);
    guided.guide(0.1);
    assertTrue(guided.state().freedrive().active());
  }

  @Test
  void aPayloadThatIsALittleWrongMakesTheArmSink() {
    guided.done(new Command.AttachLoad(Optional.of(Payload.of(0.7, 0, 0, 0.05))));
    guided.frames(1000);
    Pose start = guided.tcp();
    guided.guide(2);
    assertTrue(guided.tcp().z() < start.z() - 0.05, "sank by " + (start.z() - guided.tcp().z()));
  }

  @Test
  void withTheRightPayloadItStaysWhereItIs() {
    guided.done(new Command.AttachLoad(Optional.of(Payload.of(3, 0, 0, 0.05))));
    guided.done(new Command.DeclarePayload(3, new Vector3(0, 0, 0.05), Optional.empty()));
    guided.frames(1000);
    Pose start = guided.tcp();
    guided.guide(2);
    assertTrue(guided.distance(start) < 1e-4, "moved by " + guided.distance(start));
  }

  @Test
  void anInputCanAskForIt() {
    guided.done(
        new Command.RunSecondary(
            program("sec s():\n  set_standard_digital_input_action(3, \"freedrive\")\nend\n")));
    guided.done(new Command.SetInput("digital_in[3]", true));
    guided.frames(1);
    assertTrue(guided.state().freedrive().heldBy(FreedriveHolder.INPUT));
    guided.frames(1000);
    assertTrue(guided.state().freedrive().active(), "as long as it is high");
    guided.done(new Command.SetInput("digital_in[3]", false));
    guided.frames(1);
    assertFalse(guided.state().freedrive().active());
  }

  @Test
  void anInputCannotTakeTheArmFromAProgram() {
    guided.done(
        new Command.StartProgram(
            program(
                """
                def p():
                  set_standard_digital_input_action(3, "freedrive")
                  sleep(100)
                end
                """)));
    guided.done(new Command.SetInput("digital_in[3]", true));
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
