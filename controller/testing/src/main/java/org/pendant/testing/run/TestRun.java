package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.bench.Choices;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;
import org.pendant.testing.TestResult;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestFile;
import org.pendant.testing.source.TestScene;

/**
 * Test run: one test in a controller of its own, in virtual time, from power-on to its end.
 *
 * <p>A test that starts no program is the program of that controller itself. One that does runs
 * beside it, in each frame after it, and what it asks of the box takes effect before the next
 * frame.
 */
final class TestRun {
  /** Frames between two looks at the computer's clock. */
  private static final int FRAMES_PER_LOOK = 64;

  private final TestFile file;
  private final TestCase test;
  private final TestPrograms programs;
  private final TestSettings settings;
  private final Optional<CoverageCollector> coverage;
  private final TestObserver observer;
  private final BooleanSupplier stopped;
  private final ControllerOptions options;
  private final Controller controller;
  private final Optional<TestCell> cell;
  private final Verdict verdict;
  private final long mostFrames;
  private final TestBench bench;
  private final TestOperator operator;
  private final Wires wires;
  private final TestOutput output = new TestOutput();
  private final List<CompletableFuture<Reply>> replies = new ArrayList<>();
  private Optional<String> loss = Optional.empty();

  /** Why the cell cannot be as its file says. */
  private Optional<String> broken = Optional.empty();

  private Function<Command, CompletableFuture<Reply>> submit;

  TestRun(
      TestFile file,
      TestCase test,
      TestPrograms programs,
      Builtins<ControlBox> builtins,
      TestSettings settings,
      Optional<CoverageCollector> coverage,
      Choices choices,
      TestObserver observer,
      BooleanSupplier stopped) {
    this.file = file;
    this.test = test;
    this.programs = programs;
    this.settings = settings;
    this.coverage = coverage;
    this.observer = observer;
    this.stopped = stopped;
    bench = new TestBench(test.number(), choices, programs, this::globals);
    ControllerOptions set = programs.controller(test);
    options =
        test.startRad()
            .map(set::withStart)
            .orElse(set)
            .withSeed(settings.controller().seed())
            .withOperator(Operator.present())
            .withOutside(new Connectors(bench.peers(), bench.rpc(), bench.devices()));
    cell = test.scene().filter(scene -> !scene.alone()).flatMap(scene -> cell(scene, builtins));
    controller = cell.map(TestCell::tested).orElseGet(() -> new Controller(options, builtins));
    controller.attach(bench);
    submit = controller::submit;
    verdict = new Verdict(file, test, programs, bench);
    mostFrames = FrameTime.framesFor(test.timeoutS().orElse(settings.timeoutS()));
    operator = new TestOperator(bench.answers(), test.watches());
    wires = new Wires(bench.followers());
  }

  private Optional<TestCell> cell(TestScene scene, Builtins<ControlBox> builtins) {
    try {
      return Optional.of(TestCell.of(scene, programs, options, builtins));
    } catch (IOException e) {
      broken = Optional.of(String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  private SortedMap<String, Value> globals() {
    return controller.globals();
  }

  /** Runs it. */
  TestResult run() {
    long beganNs = System.nanoTime();
    long wallNs = settings.wallTimeout().toNanos();
    begin();
    ControllerState state;
    do {
      if (stopped.getAsBoolean()) {
        return result(TestOutcome.STOPPED, controller.state(), beganNs);
      }
      prepare();
      advance();
      state = controller.state();
      see(state);
      Optional<TestOutcome> outcome = outcome(state);
      if (outcome.isPresent()) {
        return result(outcome.get(), state, beganNs);
      }
    } while (state.frame() % FRAMES_PER_LOOK != 0 || System.nanoTime() - beganNs < wallNs);
    return result(
        verdict.late(place(state), text("tookLonger", settings.wallTimeout().toMillis() / 1e3)),
        state,
        beganNs);
  }

  private void advance() {
    if (cell.isPresent()) {
      cell.get().advance();
    } else {
      controller.advance();
    }
  }

  /** The line that the program is at: the test itself, or what it watches. */
  private int place(ControllerState state) {
    return test.watches() ? 0 : state.program().line();
  }

  /** The controller that it runs on. */
  Controller controller() {
    return controller;
  }

  /** Those that share a cell with it; empty where it is alone. */
  Optional<TestCell> cell() {
    return cell;
  }

  /** Why the cell cannot be as its file says; empty if it can. */
  Optional<String> broken() {
    return broken;
  }

  /** What that was switched on with. */
  ControllerOptions options() {
    return options;
  }

  /** Has its commands submitted by another way than that of its controller itself. */
  void submitBy(Function<Command, CompletableFuture<Reply>> way) {
    submit = way;
  }

  /** Begins it; no frame has gone by. */
  void begin() {
    observer.begins(controller);
    Program program = file.program();
    cell.ifPresent(others -> others.begin(programs));
    if (test.watches()) {
      controller.startCompanion(program);
    } else {
      post(new ProgramCommand.StartProgram(program, Optional.of(programs.ownFolder())));
    }
  }

  private void start(Program program) {
    takeCoverage();
    coverage.ifPresent(
        all ->
            program
                .coverageMap()
                .ifPresent(map -> all.include(map, programs.origin(map.source()))));
    post(new ProgramCommand.StartProgram(program, Optional.of(programs.folder(program))));
  }

  /** What the last program has reached, before another one takes its place. */
  private void takeCoverage() {
    if (coverage.isPresent() && test.watches()) {
      controller
          .coverage()
          .ifPresent(
              reached ->
                  coverage.get().add(name(), reached, programs.origin(reached.map().source())));
    }
  }

  /** What the test itself has reached of what it imports. */
  private void takeOwnCoverage() {
    if (coverage.isPresent()) {
      coverage.get().add(name());
      (test.watches() ? controller.companionCoverage() : controller.coverage())
          .ifPresent(reached -> coverage.get().add(name(), reached, file.composition()::imported));
    }
  }

  private String name() {
    return test.id().file() + ":" + test.id().name();
  }

  private void post(Command command) {
    replies.add(submit.apply(command));
  }

  /** What is to be done before the next frame. */
  void prepare() {
    bench.takeStart().ifPresent(this::start);
    bench.takeCommands().forEach(this::post);
  }

  /** Takes note of a frame that has gone by. */
  void see(ControllerState state) {
    observer.sees(state);
    bench.peers().step(state.frame());
    bench.devices().step(state.frame());
    bench.changes().see(state.io(), state.timeS());
    output.take(state);
    wires.step(state, this::post);
    loss = operator.look(state, this::post);
  }

  /** What has come of it by the end of a frame; empty while it goes on. */
  Optional<TestOutcome> outcome(ControllerState state) {
    if (loss.isPresent()) {
      return Optional.of(verdict.error("no-answer", loss.get(), place(state)));
    }
    Optional<String> others = broken.or(() -> cell.flatMap(TestCell::trouble));
    if (others.isPresent()) {
      return Optional.of(verdict.error("cell", others.get(), place(state)));
    }
    Optional<String> refusal = refusal();
    if (refusal.isPresent()) {
      return Optional.of(verdict.error("refused", refusal.get(), place(state)));
    }
    Optional<Ending> ending =
        test.watches()
            ? controller.companionEnding()
            : state.program().ending().filter(_ -> over(state));
    if (ending.isPresent()) {
      return Optional.of(verdict.of(ending.get(), state));
    }
    if (!test.watches()
        && state.program().state() == ProgramState.PAUSED
        && state.safety().stop().isPresent()) {
      // it waits for itself to unlock the stop
      return Optional.of(verdict.stopped(state));
    }
    return state.frame() >= mostFrames
        ? Optional.of(verdict.late(place(state), text("ranLonger", FrameTime.FRAME_S * mostFrames)))
        : Optional.empty();
  }

  private static boolean over(ControllerState state) {
    return state.program().state() == ProgramState.STOPPED;
  }

  private Optional<String> refusal() {
    if (replies.isEmpty()) {
      return Optional.empty();
    }
    Optional<String> complaint = Optional.empty();
    for (CompletableFuture<Reply> each : replies) {
      if (each.isDone() && complaint.isEmpty()) {
        complaint = each.join().complaint();
      }
    }
    replies.removeIf(CompletableFuture::isDone);
    return complaint;
  }

  /** The report of an outcome. */
  TestResult result(TestOutcome outcome, ControllerState state, long beganNs) {
    takeCoverage();
    takeOwnCoverage();
    return new TestResult(
        test.id(),
        test.place(),
        test.tags(),
        outcome.status(),
        outcome.skipped(),
        outcome.failure(),
        state.timeS(),
        (System.nanoTime() - beganNs) * 1e-9,
        output.lines());
  }
}
