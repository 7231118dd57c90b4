package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.safety.SpeedUse;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.explain.Cause;
import org.pendant.recording.explain.MotionExplanation;

/** How it reads why the arm moved so. */
final class MotionWordsTest {
  private static final String TEXT =
      """
      movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=1)
      movel(pose_add(get_target_tcp_pose(), p[0, 0, -0.3, 0, 0, 0]), a=1, v=0.1)
      """;

  private final ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);
  private final Controller controller = new Controller(options);
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private final MotionWords words = new MotionWords(PoseForm.STANDARD);

  @BeforeEach
  void run() {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, TEXT)));
    for (int i = 0; i < 3000; i++) {
      controller.advance();
      ring.take(controller.state());
    }
  }

  private MotionExplanation at(long frame) {
    return MotionExplanation.of(ring.recording(), frame, options.safety(), false);
  }

  @Test
  void placeAndCauseAreSaid() {
    String place = words.place(at(1250), line -> "node 7 of line " + line);
    assertTrue(place.startsWith("2.500 s, node 7 of line 2: movel("), place);
    assertEquals("Full speed of the command: 100 mm/s.", words.cause(at(1250)));
    assertEquals("The arm rests.", words.cause(at(2990)));
  }

  @Test
  void plannedAndActualStandBesideEachOther() {
    MotionWords.Row speed =
        words.rows(at(1250)).stream()
            .filter(row -> row.name().equals("Tool speed"))
            .findFirst()
            .orElseThrow();
    assertEquals(
        new MotionWords.Row("Tool speed", "100.00 mm/s", "100.00 mm/s", "0.00 mm/s"), speed);
  }

  @Test
  void everyJointHasPlaceSpeedAndTorque() {
    List<String> names = words.rows(at(1250)).stream().map(MotionWords.Row::name).toList();
    assertTrue(names.containsAll(List.of("Base", "Base speed", "Base torque")), names.toString());
  }

  private static SpeedUse use(SpeedUse.Kind kind, int joint) {
    return new SpeedUse(kind, joint, 0.5, 1, 0.5);
  }

  private String cause(Cause.Kind kind, double asked, Optional<SpeedUse> use) {
    MotionExplanation then = at(1250);
    return words.cause(
        new MotionExplanation(
            then.now(), "movel(p)", 0, 0, 0, then.uses(), new Cause(kind, true, 0.2, asked, use)));
  }

  @Test
  void whyItIsSlowerThanTheCommandAsksIsASentence() {
    Optional<SpeedUse> elbow = Optional.of(use(SpeedUse.Kind.JOINT_SPEED, 2));
    assertEquals(
        "Slower than the command asks (500 mm/s): joint speed of elbow at 50 % of 57.3\u00b0/s, as"
            + " fast as it can turn.",
        cause(Cause.Kind.JOINT_LIMIT, 0.5, elbow));
    assertEquals(
        "Slower than the command asks (500 mm/s): the way is too short, and the arm slows down from"
            + " here on.",
        cause(Cause.Kind.SHORT_WAY, 0.5, Optional.empty()));
    assertEquals(
        "Slower than the command asks (500 mm/s): what drives can do along this path, or a blend.",
        cause(Cause.Kind.PATH_LIMIT, 0.5, Optional.empty()));
  }

  @Test
  void ratesAreSaidBesideThoseOfTheCommand() {
    assertEquals(
        "Steady, at the speed that makes the move take as long as the command says: 200 mm/s.",
        cause(Cause.Kind.COMMAND_TIME, 0.2, Optional.empty()));
    assertEquals(
        "Speeding up, at 200 mm/s\u00b2, as the command says.",
        cause(Cause.Kind.ACCELERATION, 0.2, Optional.empty()));
    assertEquals(
        "Slowing down, for the end of the move or a corner, at 200 mm/s\u00b2; the command says"
            + " 500 mm/s\u00b2.",
        cause(Cause.Kind.DECELERATION, 0.5, Optional.empty()));
  }

  @Test
  void everyLimitIsNamed() {
    for (SpeedUse.Kind kind : SpeedUse.Kind.values()) {
      String said = cause(Cause.Kind.SAFETY_LIMIT, 0.5, Optional.of(use(kind, 0)));
      assertTrue(said.startsWith("Slowed down by a limit: " + kind.words()), said);
      assertTrue(said.contains(" at 50 % of 1") || said.contains(" at 50 % of 57.3"), said);
    }
  }
}
