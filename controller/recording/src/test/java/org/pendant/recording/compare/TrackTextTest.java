package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;

final class TrackTextTest {
  private static final String PROGRAM =
      """
      textmsg("begins")
      sleep(0.1)
      set_standard_digital_out(2, True)
      movej([0.5, -1.5, 1.2, -1.5, -1.5, 0], a=2, v=1)
      movel(pose_add(get_target_tcp_pose(), p[0.1, 0.1, 0, 0, 0, 0]), a=1.2, v=0.25)
      sleep(0.5)
      set_standard_digital_out(2, False)
      movej([0.1, -1.5, 0, -1.5, 0, 0], a=2, v=1)
      textmsg("ends")
      """;
  private static final TrackTolerance STANDARD =
      new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.empty(), 0.01);
  private static final TrackTolerance TCP =
      new TrackTolerance(OptionalDouble.of(0.1), OptionalDouble.of(0.2), 0.01);

  private static RunTrack run(String text) {
    Controller controller = new Controller(ControllerOptions.headless().withArm(ArmChoice.IDEAL));
    RunTrack track = new RunTrack(true);
    track.take(controller.state());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    do {
      controller.advance();
      track.take(controller.state());
    } while (controller.state().frame() < 2 || controller.state().program().line() > 0);
    return track;
  }

  private static RunTrack again(RunTrack track, TrackTolerance tolerance) throws MalformedTrack {
    return TrackText.read(TrackText.of(track, tolerance));
  }

  private static String text(RunTrack track) {
    return new String(TrackText.of(track, STANDARD), StandardCharsets.UTF_8);
  }

  @Test
  void aRunIsTheSameAsWhatWasWrittenOfIt() throws MalformedTrack {
    RunTrack track = run(PROGRAM);

    assertEquals(Optional.empty(), TrackComparison.first(track, again(track, STANDARD), STANDARD));
    assertEquals(Optional.empty(), TrackComparison.first(track, again(track, TCP), TCP));
    assertFalse(again(track, STANDARD).hasTcp());
  }

  @Test
  void placesAreOffByTheirBandAtMost() throws MalformedTrack {
    RunTrack track = run(PROGRAM);
    RunTrack read = again(track, STANDARD);

    double most = 0;
    for (long frame = 0; frame <= track.lastFrame(); frame++) {
      most = Math.max(most, track.target(frame).maxAbsDifference(read.target(frame)));
    }
    assertEquals(0.01, read.within().deg(), 1e-9);
    assertTrue(Math.toDegrees(most) < 0.0106, "" + Math.toDegrees(most));
  }

  @Test
  void aSecondOfMotionTakesLessThanFiveKilobytes() {
    RunTrack track = run(PROGRAM);
    double seconds = track.lastFrame() * 0.002;

    System.err.println(
        seconds
            + " "
            + TrackText.of(track, STANDARD).length
            + " "
            + TrackText.of(track, TCP).length);
    assertTrue(TrackText.of(track, STANDARD).length / seconds < 2000);
    assertTrue(TrackText.of(track, TCP).length / seconds < 4000);
  }

  @Test
  void aRunThatDoesSomethingElseIsFoundWithTimeAndLine() throws MalformedTrack {
    RunTrack before = again(run(PROGRAM), STANDARD);

    TrackDifference first =
        TrackComparison.first(run(PROGRAM.replace("[0.5,", "[0.6,")), before, STANDARD)
            .orElseThrow();
    assertEquals(4, first.line());
    assertTrue(first.words().contains("(may differ by 0.1° and 0.01 s)"), first.words());
    assertEquals(
        "digital_out[2] goes on at 0.132 s, did at 0.102 s (may differ by 0.01 s)",
        TrackComparison.first(run(PROGRAM.replace("(0.1)", "(0.13)")), before, STANDARD)
            .orElseThrow()
            .words());
  }

  @Test
  void theTextIsALineForEachChange() {
    List<String> lines = text(run(PROGRAM)).lines().toList();

    assertEquals("Pendant golden recording, version 1", lines.get(0));
    assertEquals("within 0.01 deg", lines.get(1));
    assertTrue(lines.contains("0.102 digital_out[2] on"), lines::toString);
    assertTrue(lines.contains("0.002 says \"begins\""), lines::toString);
    assertTrue(lines.getLast().endsWith(" ends"), lines::toString);
  }

  @Test
  void anyTextThatAProgramWritesIsReadAgain() throws MalformedTrack {
    RunTrack track =
        new RunTrack(
            List.of(run("sleep(0.1)\n").at(0)),
            List.of(),
            List.of(
                new RunTrack.Text(0, "a \"b\" \\c\n\t"),
                new RunTrack.Text(0, "\u00c3\u00a9 \u00e2\u0082\u00ac \u00f0\u009f\u00a4\u0096"),
                new RunTrack.Text(1, "\u00ff\u0080 no text"),
                new RunTrack.Text(2, "\u00c2\u0085 and \u00e2\u0080\u00a8"),
                new RunTrack.Text(3, "")),
            5,
            new RunTrack.Within(0, 0));

    assertEquals(track.texts(), again(track, STANDARD).texts());
    assertTrue(text(track).contains("says \"é € 🤖\""), text(track));
  }

  @Test
  void aTextThatIsNoneSaysInWhichLine() {
    String whole = text(run("sleep(0.1)\n"));
    assertEquals("is no golden recording", refusal("something else"));
    assertEquals(
        "is of a later version of Pendant", refusal(whole.replace("version 1", "version 2")));
    assertEquals("ends too early", refusal(whole.substring(0, whole.lastIndexOf("\n", 80))));
    assertEquals(
        "line 3 is no line of a golden recording", refusal(whole.replaceFirst(" at ", " at x ")));
    assertEquals(
        "line 2 is no line of a golden recording", refusal(whole.replaceFirst("within", "with")));
    assertEquals(
        "line 3 is no line of a golden recording",
        refusal(whole.replaceFirst(" deg\n", " deg\n1.0 digital_out[9] on\n")));
  }

  private static String refusal(String text) {
    return assertThrows(
            MalformedTrack.class, () -> TrackText.read(text.getBytes(StandardCharsets.UTF_8)))
        .getMessage();
  }
}
