package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordingMark.Kind;
import org.pendant.script.variables.VariablePath;

/** What can be asked of a recording. */
final class RecordingTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private final List<ControllerState> states = new ArrayList<>(List.of(controller.state()));

  private void start(String text) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
  }

  private Recording run(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      ControllerState state = controller.state();
      states.add(state);
      ring.take(state);
    }
    return ring.recording();
  }

  @Test
  void eachGroupAndPartStandsAtItsIndex() {
    int index = 0;
    for (NumberGroup each : NumberGroup.values()) {
      assertEquals(index, each.index());
      index++;
    }
    for (int i = 0; i < SnapshotPart.COUNT; i++) {
      assertEquals(i, SnapshotPart.PARTS.get(i).index());
    }
    assertTrue(
        NumberGroup.COUNT < Integer.SIZE && SnapshotPart.COUNT < Integer.SIZE, "masks are ints");
  }

  @Test
  void logHasTheLinesOfAStretch() {
    start("textmsg(\"a\")\nsleep(1)\ntextmsg(\"b\")\nsleep(1)\ntextmsg(\"c\")\n");
    Recording recording = run(1500);

    assertEquals(List.of("a", "b"), texts(recording.log(0, 1.5)));
    assertEquals(List.of("b", "c"), texts(recording.log(0.5, 10)));
    assertEquals(List.of(), texts(recording.log(1.1, 1.9)));
  }

  private static List<String> texts(List<LogEntry> entries) {
    return entries.stream().map(LogEntry::text).toList();
  }

  @Test
  void marksTellStartsLabelsAndEnds() {
    start(
        """
        def prog():
          $ 1 "Move"
          sleep(0.5)
          $ 2 "Wait"
          sleep(0.5)
        end
        """);
    Recording recording = run(600);

    assertEquals(
        List.of(
            Kind.PROGRAM_STARTED + " prog 0",
            Kind.LABEL + " Move 3",
            Kind.LABEL + " Wait 5",
            Kind.PROGRAM_ENDED + " prog 0"),
        recording.marks().stream()
            .map(
                each ->
                    each.kind()
                        + " "
                        + each.text()
                        + " "
                        + (each.kind() == Kind.LABEL ? each.line() : 0))
            .toList());
    assertEquals(0.5, recording.marks().get(2).timeS(), 0.01);
  }

  @Test
  void marksTellFailuresAndStops() {
    start("sleep(0.1)\nprotective_stop()\nsleep(1)\n");
    run(200);
    var _ = controller.submit(new ProgramCommand.StopProgram());
    run(2);
    start("a = [1]\nb = a[2]\n");
    Recording recording = run(100);

    List<RecordingMark> marks = recording.marks();
    RecordingMark stop =
        marks.stream().filter(each -> each.kind() == Kind.PROTECTIVE_STOP).findAny().orElseThrow();
    assertTrue(stop.text().contains("protective stop"), stop.text());
    assertEquals(2, stop.line());
    assertEquals(1, marks.stream().filter(each -> each.kind() == Kind.PROTECTIVE_STOP).count());
  }

  @Test
  void aFailedProgramIsMarkedWithItsReasonAndLine() {
    start("a = [1]\nsleep(0.1)\nb = a[2]\n");
    RecordingMark failed = run(100).marks().getLast();

    assertEquals(Kind.PROGRAM_FAILED, failed.kind());
    assertTrue(failed.text().contains("index"), failed.text());
    assertEquals(3, failed.line());
  }

  @Test
  void programsAreKnownByTheTimeTheyRan() {
    start("a = 1\nsleep(0.1)\n");
    run(100);
    start("b = 1\nsleep(0.1)\n");
    Recording recording = run(100);

    assertTrue(recording.programAt(0).isEmpty());
    assertEquals("a = 1", recording.programAt(0.1).orElseThrow().source().lineText(1));
    assertEquals("b = 1", recording.programAt(0.4).orElseThrow().source().lineText(1));
  }

  @Test
  void aScanHasTheExtremesOfEachStretch() {
    start("movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)\nmovej([0, -1.6, -1.5, -1.5, 1.5, 0])\n");
    Recording recording = run(1200);
    ColumnTrace trace = recording.scan(Column.of("target_q", 1), 0, 2.4, 24);

    assertEquals(24, trace.size());
    for (int i = 0; i < trace.size(); i++) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (ControllerState each : states.subList(50 * i, 50 * i + 50)) {
        low = Math.min(low, each.arm().targetPositionRad().get(1));
        high = Math.max(high, each.arm().targetPositionRad().get(1));
      }
      assertEquals(0.1 * i, trace.timeS(i), 1e-9);
      assertEquals(low, trace.lowest(i), "stretch " + i);
      assertEquals(high, trace.highest(i), "stretch " + i);
      assertEquals(
          states.get(50 * i + 49).arm().targetPositionRad().get(1), trace.last(i), "stretch " + i);
    }
  }

  @Test
  void aScanHoldsWhatDoesNotChangeAndHasNothingOutside() {
    run(500);
    ColumnTrace trace = ring.recording().scan(Column.line(), -0.5, 1.5, 20);

    assertTrue(Double.isNaN(trace.last(4)), "before the first frame");
    assertEquals(0, trace.last(5));
    assertEquals(0, trace.lowest(14));
    assertTrue(Double.isNaN(trace.last(16)), "after the last frame");
  }

  @Test
  void linesVariablesAndSignalsCanBeScanned() {
    start(
        """
        global n = 3
        sleep(0.5)
        n = 7
        set_standard_digital_out(2, True)
        sleep(0.5)
        """);
    Recording recording = run(400);

    ColumnTrace line = recording.scan(Column.line(), 0, 0.8, 8);
    assertEquals(2, line.last(2));
    assertEquals(5, line.last(7));
    ColumnTrace n = recording.scan(Column.variable(VariablePath.of("n")), 0, 0.8, 8);
    assertEquals(3, n.last(2));
    assertEquals(7, n.last(7));
    ColumnTrace out =
        recording.scan(Column.digital(new Signal(SignalBank.STANDARD_OUT, 2)), 0, 0.8, 8);
    assertEquals(0, out.last(2));
    assertEquals(1, out.last(7));
    ColumnTrace none = recording.scan(Column.variable(VariablePath.of("m")), 0, 0.8, 8);
    assertTrue(Double.isNaN(none.last(7)), "there is no m");
  }

  @Test
  void theSpeedOfTheTcpIsWorkedOut() {
    start("movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)\n");
    Recording recording = run(400);
    ColumnTrace trace = recording.scan(Column.of("tcp_speed", 0), 0, 0.8, 400);

    for (int i = 10; i < 200; i += 10) {
      var speed = states.get(i).geometry().actual().speed();
      assertEquals(
          Math.sqrt(speed.x() * speed.x() + speed.y() * speed.y() + speed.z() * speed.z()),
          trace.last(i),
          1e-12);
    }
  }

  @Test
  void aScanOfNothingIsRefused() {
    Recording recording = run(10);
    Column line = Column.line();

    assertThrows(IllegalArgumentException.class, () -> recording.scan(line, 1, 1, 10));
    assertThrows(IllegalArgumentException.class, () -> recording.scan(line, 0, 1, 0));
    assertThrows(IndexOutOfBoundsException.class, () -> Column.of("target_q", 6));
  }
}
