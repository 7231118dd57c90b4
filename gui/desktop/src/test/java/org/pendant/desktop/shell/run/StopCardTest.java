package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.safety.StopCategory;
import org.pendant.controller.state.StopPlace;
import org.pendant.desktop.session.ArmReadiness;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

final class StopCardTest {
  private final Controller controller =
      new Controller(ControllerOptions.headless().withPower(false));

  private void send(Command command) {
    var reply = controller.submit(command);
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
  }

  private void switchOn() {
    send(ArmReadiness.of(controller.state()).command().orElseThrow());
    assertTrue(
        controller.runUntil(
            () -> controller.state().safety().robotMode() == RobotMode.RUNNING, 5000));
  }

  private void start(String text) {
    send(new ProgramCommand.StartProgram(TestController.program(controller, text)));
  }

  @Test
  void theStopCardSaysWhatAndWhereAndWhatToDo() {
    switchOn();
    assertEquals(Optional.empty(), StopCard.of(controller.state()));
    start("sleep(0.1)\nprotective_stop()\nsleep(5)\n");
    controller.runUntil(() -> controller.state().safety().stop().isPresent(), 200);
    StopCard card = StopCard.of(controller.state()).orElseThrow();
    assertEquals("Protective stop C209A0", card.title());
    assertEquals(2, card.line());
    assertEquals("Unlock the arm, then resume the program or start it again.", card.suggestion());
    assertEquals("The program asks for it", card.message());
    assertEquals(
        "491.90, -133.30, 487.90 mm",
        card.facts().stream()
            .filter(each -> each.name().equals("TCP in the base"))
            .findAny()
            .orElseThrow()
            .value());
  }

  @Test
  void sentenceOfAStopNamesJointsAndHasTheUnitsOfTheScreens() {
    SafetyStop stop =
        new SafetyStop(
            SafetyMode.PROTECTIVE_STOP,
            StopCategory.TWO,
            154,
            0,
            OptionalInt.empty(),
            1.5,
            0,
            0,
            "",
            "C154A0 protective stop at 1.500 s: the path to \"bin 2 m\" bends: joint 2 would turn"
                + " at more than 157.079633 rad/s within 0.25 m; on the way to p[0.95, 0, 1, 2, 3,"
                + " 0]");
    assertEquals(
        "The path to \"bin 2 m\" bends: elbow would turn at more than 9000.00\u00b0/s within"
            + " 250.00 mm; on the way to p[0.95, 0, 1, 2, 3, 0]",
        StopCard.of(stop, Optional.empty(), List.of(), PoseForm.STANDARD).message());
    PoseForm form = new PoseForm(DisplayUnit.METRE, DisplayUnit.RADIAN, RotationForm.VECTOR);
    String message = StopCard.of(stop, Optional.empty(), List.of(), form).message();
    assertTrue(
        message.contains("elbow would turn at more than 157.07963 rad/s within 0.25000 m"),
        message);
  }

  @Test
  void sentenceOfAStopNamesAJointOnce() {
    SafetyStop stop =
        new SafetyStop(
            SafetyMode.PROTECTIVE_STOP,
            StopCategory.TWO,
            157,
            1,
            OptionalInt.of(1),
            1.5,
            167,
            52,
            "Nm",
            "C157A1 protective stop at 1.500 s: shoulder (joint 1) is pushed from outside: 167 Nm,"
                + " limit 52 Nm");
    assertEquals(
        "Shoulder is pushed from outside",
        StopCard.of(stop, Optional.empty(), List.of(), PoseForm.STANDARD).message());
  }

  @Test
  void theStopCardHasEachNumberOnceAndOfWhatTheSafetyFunctionsLookedAt() {
    SafetyStop stop =
        new SafetyStop(
            SafetyMode.PROTECTIVE_STOP,
            StopCategory.TWO,
            152,
            0,
            OptionalInt.empty(),
            1.5,
            -0.00006,
            0,
            "m",
            "C152A0 protective stop at 1.500 s: tool comes too close to safety plane \"a: b\":"
                + " -0.00006 m, limit 0 m");
    StopPlace place = new StopPlace(3, new Pose(0.1, 0, 0.25, 0, 0, 0), Joints.ZERO);
    StopCard card = StopCard.of(stop, Optional.of(place), List.of(), PoseForm.STANDARD);
    assertEquals("Protective stop C152A0", card.title());
    assertEquals("Tool comes too close to safety plane \"a: b\"", card.message());
    assertEquals(
        List.of(
            new StopCard.Fact("It would come to rest at", "-0.06 mm"),
            new StopCard.Fact("Limit", "0.00 mm"),
            new StopCard.Fact("TCP in the base, as commanded", "100.00, 0.00, 250.00 mm"),
            new StopCard.Fact("Robot time", "1.500 s")),
        card.facts());
  }

  @Test
  void theStopCardKeepsTheLineOfAProgramThatTheStopHasEnded() {
    switchOn();
    start("sleep(0.1)\nsleep(5)\n");
    controller.runUntil(() -> controller.state().program().line() == 2, 200);
    send(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    controller.runUntil(() -> controller.state().safety().stop().isPresent(), 10);
    controller.runUntil(() -> controller.state().program().line() == 0, 1000);
    assertEquals(2, StopCard.of(controller.state()).orElseThrow().line());
  }
}
