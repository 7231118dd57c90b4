package org.pendant.bench;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.controller.Controller;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * One frame of the controller while one script thread waits: for a joint move, for a straight move,
 * or for time with the arm at rest. Moves take thousands of frames, so planning them is a small
 * part of the mean.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 4, time = 1)
public class FrameBenchmark {
  @Param({"movej", "movel", "sleep"})
  String waitsFor;

  private Controller controller;

  /** Starts the program and lets it get under way. */
  @Setup
  public void start() {
    BenchmarkScript script = BenchmarkScript.load("frame_" + waitsFor);
    script.start();
    controller = script.controller();
    for (int i = 0; i < 10_000; i++) {
      controller.advance();
    }
  }

  /** One frame and its snapshot. */
  @Benchmark
  public ControllerState frame() {
    controller.advance();
    return controller.state();
  }

  /** One frame whose snapshot nobody asks for. */
  @Benchmark
  public void frameThatNobodyLooksAt() {
    controller.advance();
  }

  /** Looks whether the frames were what they should be. */
  @TearDown
  public void check() {
    ControllerState state = controller.state();
    if (state.program().state() != ProgramState.RUNNING) {
      throw new IllegalStateException("the program ended: " + state.program().ending());
    }
    if (state.arm().moving() == waitsFor.equals("sleep")) {
      // Between two moves the arm is at rest for a frame or two.
      controller.runUntil(() -> controller.state().arm().moving(), 10);
      if (controller.state().arm().moving() == waitsFor.equals("sleep")) {
        throw new IllegalStateException(waitsFor + ": the arm does not do what it should");
      }
    }
  }
}
