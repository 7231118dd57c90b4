package org.pendant.bench;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.script.vm.ProgramState;

/**
 * One {@code bench_*.script} on a controller of its own, run as {@code pendant run} does it.
 *
 * <p>Whatever goes wrong is an {@link IllegalStateException}: a benchmark of a program that fails
 * would only look fast.
 */
final class BenchmarkScript {
  /** An hour of virtual time; no benchmark comes near. */
  private static final long MAX_FRAMES = 1_800_000;

  private final Controller controller;
  private final Program program;

  private BenchmarkScript(Controller controller, Program program) {
    this.controller = controller;
    this.program = program;
  }

  /** Reads {@code bench_<name>.script}. */
  static Source source(String name) {
    String file = "bench_" + name + ".script";
    try (InputStream in = BenchmarkScript.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalArgumentException("no resource is named " + file);
      }
      return Source.of(file, in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Loads {@code bench_<name>.script} on a new controller. */
  static BenchmarkScript load(String name) {
    return load(source(name));
  }

  /** Loads a program on a new controller. */
  static BenchmarkScript load(Source source) {
    return load(source, new Controller(ControllerOptions.headless()));
  }

  /** Loads a program on a controller. */
  static BenchmarkScript load(Source source, Controller controller) {
    return of(controller, source, controller.load(source));
  }

  /** As {@link #load(Source)}, compiled for coverage. */
  static BenchmarkScript loadCovered(Source source) {
    Controller controller = new Controller(ControllerOptions.headless());
    return of(controller, source, ProgramLoader.loadCovered(source, controller.builtins()));
  }

  private static BenchmarkScript of(Controller controller, Source source, LoadResult loaded) {
    Program program =
        loaded
            .program()
            .orElseThrow(() -> new IllegalStateException(source.name() + " has errors"));
    return new BenchmarkScript(controller, program);
  }

  Controller controller() {
    return controller;
  }

  /** Starts the program and leaves it running. */
  void start() {
    var reply = controller.submit(new ProgramCommand.StartProgram(program));
    controller.advance();
    if (!reply.isDone()) {
      throw new IllegalStateException(program.name() + " was not started");
    }
  }

  /**
   * Runs the program to its end.
   *
   * @return its global variable {@code result}
   */
  double runToEnd() {
    start();
    if (controller.state().program().state() != ProgramState.STOPPED
        && !controller.runUntil(this::stopped, MAX_FRAMES)) {
      throw new IllegalStateException(program.name() + " did not end");
    }
    ControllerState state = controller.state();
    if (!(state.program().ending().orElseThrow() instanceof Ending.Finished)) {
      throw new IllegalStateException(program.name() + ": " + state.program().ending());
    }
    Value result = controller.globals().get("result");
    if (result == null) {
      throw new IllegalStateException(program.name() + " left no result");
    }
    return Double.parseDouble(result.text());
  }

  private boolean stopped() {
    return controller.state().program().state() == ProgramState.STOPPED;
  }
}
