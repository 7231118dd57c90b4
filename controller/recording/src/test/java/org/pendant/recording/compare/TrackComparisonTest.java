package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.recording.RecordingRing;

final class TrackComparisonTest {
  private static final String PROGRAM =
      """
      textmsg("begins")
      sleep(0.1)
      set_standard_digital_out(2, True)
      movej([0.1, -1.5, 0, -1.5, 0, 0], a=2, v=1)
      textmsg("ends")
      """;
  private static final TrackTolerance STANDARD =
      new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.empty(), 0.01);

  private static RecordingRing ring(String text, RunTrack track) {
    Controller controller = new Controller(ControllerOptions.headless().withArm(ArmChoice.IDEAL));
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    track.take(controller.state());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    do {
      controller.advance();
      ring.take(controller.state());
      track.take(controller.state());
    } while (controller.state().frame() < 2 || controller.state().program().line() > 0);
    return ring;
  }

  private static RunTrack run(String text) {
    RunTrack track = new RunTrack(true);
    var _ = ring(text, track);
    return track;
  }

  private static Optional<TrackDifference> difference(String text, TrackTolerance tolerance) {
    return TrackComparison.first(run(text), run(PROGRAM), tolerance);
  }

  private static String words(String text) {
    return difference(text, STANDARD).orElseThrow().words();
  }

  @Test
  void aRunIsTheSameAsItsRecording() {
    RunTrack track = new RunTrack(true);
    RunTrack recorded = RunTrack.of(ring(PROGRAM, track).recording(), true);

    assertEquals(Optional.empty(), TrackComparison.first(track, recorded, STANDARD));
    assertEquals(2, recorded.texts().size());
    assertEquals(track.lastFrame(), recorded.lastFrame());
  }

  @Test
  void whatComesALittleLaterIsTheSameWithinTheBandOfTimeAlone() {
    String later = PROGRAM.replace("0.1)", "0.108)");

    assertEquals(Optional.empty(), difference(later, STANDARD));
    assertEquals(
        "digital_out[2] goes on at 0.110 s, did at 0.102 s (may differ by 0.004 s)",
        difference(later, new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.empty(), 0.004))
            .orElseThrow()
            .words());
  }

  @Test
  void anArmThatGoesElsewhereIsFoundWithJointValuesAndLine() {
    TrackDifference difference =
        difference(PROGRAM.replace("[0.1,", "[0.2,"), STANDARD).orElseThrow();

    assertEquals(4, difference.line());
    assertTrue(difference.words().contains("the target of joint 0 is "), difference.words());
  }

  @Test
  void whatDiffersFirstHasACurveOfBothRunsAroundThatMoment() {
    TrackDifference ofArm = difference(PROGRAM.replace("[0.1,", "[0.2,"), STANDARD).orElseThrow();
    TrackCurves joint = ofArm.curves().orElseThrow();
    assertEquals("Joint 0", joint.what());
    assertEquals(ofArm.frame() / 500.0, joint.atS(), 1e-9);
    TrackCurves.Point last = joint.before().getLast();
    assertEquals(joint.atS() + 0.25, last.timeS(), 1e-9);
    assertTrue(joint.now().getLast().value() > last.value() + 0.1);

    TrackCurves output =
        difference(PROGRAM.replace("2, True", "2, False"), STANDARD)
            .orElseThrow()
            .curves()
            .orElseThrow();
    assertEquals("digital_out[2]", output.what());
    assertEquals(0, output.now().getLast().value());
    assertEquals(1, output.before().getLast().value());

    assertTrue(
        difference(PROGRAM.replace("begins", "starts"), STANDARD).orElseThrow().curves().isEmpty());
  }

  @Test
  void anArmMayBeSomewhereMuchLaterWhereTheBandOfTimeIsWide() {
    String later = PROGRAM.replace("(0.1)", "(0.4)");

    assertEquals(
        Optional.empty(),
        difference(
            later, new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.empty(), 0.31)));
    assertTrue(
        difference(later, new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.empty(), 0.29))
            .isPresent());
  }

  @Test
  void aPlaceOfTheToolMayDifferByMillimetres() {
    String nearby = PROGRAM.replace("[0.1,", "[0.101,");
    OptionalDouble any = OptionalDouble.empty();

    assertEquals(
        Optional.empty(), difference(nearby, new TrackTolerance(any, OptionalDouble.of(2), 0.01)));
    assertEquals(
        4,
        difference(nearby, new TrackTolerance(any, OptionalDouble.of(0.2), 0.01))
            .orElseThrow()
            .line());
  }

  @Test
  void anOutputThatStaysIsFoundWhenItWentOn() {
    TrackDifference difference =
        difference(PROGRAM.replace("(2, True)", "(2, False)"), STANDARD).orElseThrow();

    assertEquals("at 0.102 s digital_out[2] does not go on, did", difference.words());
    assertEquals(51, difference.frame());
  }

  @Test
  void anOutputThatIsNewIsFound() {
    assertEquals(
        "at 0.102 s digital_out[3] goes on, did not",
        words(PROGRAM.replace("(2, True)", "(2, True)\nset_standard_digital_out(3, True)")));
  }

  @Test
  void anotherLineOfTextIsFound() {
    assertEquals(
        "at 0.002 s the log says \"starts\", said \"begins\"",
        words(PROGRAM.replace("begins", "starts")));
  }

  @Test
  void aRunThatTakesLongerIsFoundWhereTheOtherOneEnded() {
    String words = words(PROGRAM + "sleep(0.2)\n");

    assertEquals("the test takes ", words.substring(0, 15));
  }
}
