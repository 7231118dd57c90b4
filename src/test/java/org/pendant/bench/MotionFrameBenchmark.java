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
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.motion.PlanningException;

/** A frame of every motion, in which nothing is planned; {@link SteadyMotion} says which. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class MotionFrameBenchmark {
  @Param SteadyMotion.Kind kind;

  private SteadyMotion motion;

  /** Begins the motion. */
  @Setup
  public void begin() throws PlanningException {
    motion = new SteadyMotion(kind);
  }

  /** A frame. */
  @Benchmark
  public double frame() throws PlanningException {
    motion.frame();
    return motion.seen();
  }
}
