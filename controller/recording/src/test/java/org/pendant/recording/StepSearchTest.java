package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.value.IntValue;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;

final class StepSearchTest {
  private static final VariablePath I = VariablePath.of("i");
  private static final String SLEEPS =
      """
      i = 0
      sleep(0.1)
      i = 1
      sleep(0.1)
      i = 2
      sleep(0.1)
      """;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);

  private StepSearchTest start(String text) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    return this;
  }

  private StepSearchTest frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      ring.take(controller.state());
    }
    return this;
  }

  private void ask(Consumer<Debugger> request) {
    var _ = controller.submit(new DebugCommand.Debug(request));
    frames(1);
  }

  private Moment now() {
    return Moment.of(controller.state());
  }

  private StepSearch search() {
    return new StepSearch(ring.recording());
  }

  private List<Integer> linesBack() {
    List<Integer> lines = new ArrayList<>();
    Optional<RecordedStep> step = search().before(now());
    while (step.isPresent()) {
      lines.add(step.get().line());
      step = search().before(step.get().moment());
    }
    return lines;
  }

  @Test
  void stepsBackToWhereEachStatementBegan() {
    start(SLEEPS).frames(200);
    RecordedStep last = search().before(now()).orElseThrow();
    RecordedStep before = search().before(last.moment()).orElseThrow();

    assertEquals(List.of(6, 4, 2), linesBack());
    assertEquals(50, last.moment().frame() - before.moment().frame());
    assertEquals(4, ring.recording().at(before.moment()).program().line());
  }

  @Test
  void stepsBackWithinAStatementToItsBeginning() {
    start(SLEEPS).frames(75);
    assertEquals(4, controller.state().program().line());
    assertEquals(List.of(4, 2), linesBack());
  }

  @Test
  void stepsOnAsItStepsBack() {
    start(SLEEPS).frames(200);
    List<Integer> lines = new ArrayList<>();
    Optional<RecordedStep> step = search().after(Moment.endOf(0));
    while (step.isPresent()) {
      lines.add(step.get().line());
      step = search().after(step.get().moment());
    }
    assertEquals(List.of(2, 4, 6), lines);
  }

  @Test
  void everyStopOfADebuggerIsAStepAlsoWithinOneFrame() {
    ask(debugger -> debugger.set(Breakpoint.at(1)));
    start("i = 0\ni = 1\ni = 2\ni = 3\nsleep(0.1)\n").frames(2);
    for (int i = 0; i < 3; i++) {
      ask(debugger -> debugger.stepOver(Debugger.MAIN));
    }
    assertEquals(4, controller.state().debug().stop().orElseThrow().line());
    assertEquals(List.of(3, 2, 1), linesBack());

    RecordedStep before = search().before(now()).orElseThrow();
    assertEquals(now().frame(), before.moment().frame());
    var then = ring.recording().at(before.moment());
    assertEquals(3, then.debug().stop().orElseThrow().line());
    assertEquals(
        Optional.of(new IntValue(1)), then.variables().find(I).flatMap(VariableSample::value));
  }

  @Test
  void aBreakpointInALoopIsFoundOnceATurn() {
    ask(debugger -> debugger.set(Breakpoint.at(3)));
    start("i = 0\nwhile True:\n  i = i + 1\n  sleep(0.1)\nend\n").frames(5);
    for (int i = 0; i < 3; i++) {
      ask(Debugger::resume);
      frames(100);
    }
    var before =
        search()
            .before(
                now(),
                Set.of(3),
                step ->
                    step.stop()
                        .filter(stop -> stop.reason() instanceof PauseReason.AtBreakpoint)
                        .isPresent())
            .orElseThrow();
    assertEquals(3, before.line());
    assertEquals(
        Optional.of(new IntValue(2)), before.variables().find(I).flatMap(VariableSample::value));
  }

  @Test
  void aVariableIsFollowedToItsLastAndNextChange() {
    start(SLEEPS).frames(200);
    RecordedChange last = search().changeBefore(now(), I).orElseThrow();
    RecordedChange before = search().changeBefore(last.moment(), I).orElseThrow();

    assertEquals(Optional.of(new IntValue(2)), last.after().flatMap(VariableSample::value));
    assertEquals(Optional.of(new IntValue(1)), last.before().flatMap(VariableSample::value));
    assertEquals(Optional.of(new IntValue(1)), before.after().flatMap(VariableSample::value));
    assertEquals(
        Optional.of(last.moment()),
        search().changeAfter(before.moment(), I).map(RecordedChange::moment));
    assertTrue(search().changeBefore(now(), VariablePath.of("nothing")).isEmpty());
  }

  @Test
  void aChangeIsKnownToTheFrameInWhichTheProgramCameToAnotherLine() {
    start(SLEEPS).frames(200);
    RecordedChange last = search().changeBefore(now(), I).orElseThrow();
    RecordedStep step = search().before(now()).orElseThrow();
    assertEquals(step.moment(), last.moment());
  }

  @Test
  void findsWhatIsManySegmentsBack() {
    start(SLEEPS + "movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=0.3, v=0.05)\n").frames(6000);
    assertTrue(ring.recording().stretches() > 3);
    assertEquals(List.of(7, 6, 4, 2), linesBack());
    assertEquals(
        Optional.of(new IntValue(2)),
        search()
            .changeBefore(now(), I)
            .flatMap(RecordedChange::after)
            .flatMap(VariableSample::value));
  }

  @Test
  void anIndexOfAFileLeavesOutWhatHasNothingOnly(@TempDir Path folder) throws IOException {
    start(
            """
            i = 0
            sleep(0.1)
            while True:
              movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=0.3, v=0.2)
              movej([0, -1.5, -1.5, -1.5, 1.5, 0], a=0.3, v=0.2)
              i = i + 1
            end
            """)
        .frames(6000);
    Path file = folder.resolve("run.rec");
    Recording memory = ring.recording();
    RecordingExport.toRec(memory, memory.firstS(), memory.lastS(), file);
    Recording indexed = RecordingFile.open(file).recording();
    indexed.makeIndex();

    assertTrue(indexed.index().lacks(indexed.stretches() - 1, Set.of(2)));
    assertTrue(indexed.index().lacks(1, "nothing"));
    for (long frame = 0; frame <= memory.lastFrame(); frame += 97) {
      Moment from = Moment.endOf(frame);
      for (Set<Integer> lines : List.of(Set.of(2), Set.of(4), Set.of(5, 1))) {
        assertEquals(
            new StepSearch(memory).before(from, lines, step -> true).map(RecordedStep::moment),
            new StepSearch(indexed).before(from, lines, step -> true).map(RecordedStep::moment));
        assertEquals(
            new StepSearch(memory).after(from, lines, step -> true).map(RecordedStep::moment),
            new StepSearch(indexed).after(from, lines, step -> true).map(RecordedStep::moment));
      }
      assertEquals(
          new StepSearch(memory).changeBefore(from, I).map(RecordedChange::moment),
          new StepSearch(indexed).changeBefore(from, I).map(RecordedChange::moment));
      assertEquals(
          new StepSearch(memory).changeAfter(from, I).map(RecordedChange::moment),
          new StepSearch(indexed).changeAfter(from, I).map(RecordedChange::moment));
    }
  }
}
