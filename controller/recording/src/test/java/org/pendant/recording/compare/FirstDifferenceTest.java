package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;

final class FirstDifferenceTest {
  private static final String PROGRAM =
      """
      sleep(0.1)
      set_standard_digital_out(0, True)
      movej([0.8, -1.5, -1.5, -1.5, 1.5, 0], a=1, v=0.5)
      sleep(0.1)
      """;

  private static Recording run(ControllerOptions options, int framesBefore, String text) {
    Controller controller = new Controller(options);
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    for (int i = 0; i < framesBefore + 1_000; i++) {
      if (i == framesBefore) {
        var _ =
            controller.submit(
                new ProgramCommand.StartProgram(TestController.program(controller, text)));
      }
      controller.advance();
      ring.take(controller.state());
    }
    return ring.recording();
  }

  private static Recording run(String text) {
    return run(ControllerOptions.headless(), 50, text);
  }

  @Test
  void runsThatDoTheSameHaveNoneWheneverTheyBegan() {
    assertEquals(Optional.empty(), FirstDifference.between(run(PROGRAM), run(PROGRAM)));
    assertEquals(
        Optional.empty(),
        FirstDifference.between(
            run(ControllerOptions.headless(), 50, "sleep(0.2)\n"),
            run(ControllerOptions.headless(), 75, "sleep(0.2)\n")));
  }

  @Test
  void anOutputThatIsSetLaterIsFoundInItsFrameWithLineAndText() {
    FirstDifference difference =
        FirstDifference.between(run(PROGRAM.replace("(0.1)\nset", "(0.2)\nset")), run(PROGRAM))
            .orElseThrow();
    assertEquals(0.1, difference.sinceStartS(), 1e-9);
    assertEquals(0.1 + 51 * 0.002, difference.nowS(), 1e-9);
    assertEquals(1, difference.line());
    assertEquals(3, difference.lineBefore());
    assertEquals(OptionalInt.of(1), difference.textLine());
    assertTrue(difference.what().contains("digital_out[0] 0, was 1"), difference.what().toString());
    assertTrue(
        difference.words().startsWith("differs first 0.100 s after the start, in line 1"),
        difference.words());
  }

  @Test
  void nodesAreNamedInThePlaceOfLinesWhereTheyCanBeTold() {
    FirstDifference difference =
        new FirstDifference(
            0.1, 5.1, 8, 7, List.of("digital_out[0] 0, was 1"), false, OptionalInt.of(6));
    assertEquals(
        "differs first 0.100 s after the start, in node 4 (was in line 7): digital_out[0] 0, was 1."
            + " The texts of the programs differ from node 3 on",
        difference.words(line -> "node " + line / 2, 1));
  }

  @Test
  void aSpeedThatIsChangedIsFoundWhereTheArmGoesOtherwise() {
    FirstDifference difference =
        FirstDifference.between(run(PROGRAM.replace("v=0.5", "v=0.4")), run(PROGRAM)).orElseThrow();
    assertEquals(3, difference.line());
    assertEquals(OptionalInt.of(3), difference.textLine());
    assertTrue(difference.what().getFirst().startsWith("target position of joint "));
    int more = difference.what().size() - 1;
    assertTrue(
        difference
            .words(line -> "line " + line, 1)
            .contains(difference.what().getFirst() + "; and " + more + " more. The texts"),
        difference.toString());
  }

  @Test
  void aProgramThatEndsEarlierIsFoundThere() {
    FirstDifference difference =
        FirstDifference.between(run("sleep(0.1)\n"), run("sleep(0.2)\n")).orElseThrow();
    assertEquals(0.1, difference.sinceStartS(), 0.003);
  }

  @Test
  void readingsThatDifferAloneAreCalledThat() {
    ControllerOptions noisy = ControllerOptions.headless().withEncoderNoise(1e-5);
    FirstDifference difference =
        FirstDifference.between(
                run(noisy.withSeed(1), 50, "sleep(0.1)\n"),
                run(noisy.withSeed(2), 50, "sleep(0.1)\n"))
            .orElseThrow();
    assertTrue(difference.measured());
    assertEquals(OptionalInt.empty(), difference.textLine());
  }

  @Test
  void withoutAProgramThereIsNothingToCompare() {
    Recording idle =
        new RecordingRing(new Controller(ControllerOptions.headless()).state(), Optional::empty)
            .recording();
    assertEquals(
        "no program starts in the second recording",
        assertThrows(
                IllegalArgumentException.class,
                () -> FirstDifference.between(run("sleep(0.1)\n"), idle))
            .getMessage());
  }
}
