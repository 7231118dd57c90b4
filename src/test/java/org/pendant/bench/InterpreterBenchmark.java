package org.pendant.bench;

import java.util.Map;
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

/**
 * Programs that only compute, from their start to their end on the controller. The folder {@code
 * compare} has the same tasks for other interpreters.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 3, time = 1)
public class InterpreterBenchmark {
  /** What each task computes; other interpreters agree. */
  private static final Map<String, Double> RESULTS =
      Map.of(
          "fib", 196_418.0,
          "loops", 30_000_000.0,
          "strings", 209_810.0,
          "matrix", 1_074_250.0,
          "matrix_operator", 1_074_250.0,
          "poses", -25_634.418684);

  /** The programs print six decimals, and orders of summation differ. */
  private static final double TOLERANCE = 1e-5;

  @Param({"fib", "loops", "strings", "matrix", "matrix_operator", "poses"})
  String task;

  private BenchmarkScript script;
  private double expected;

  /** Loads the program. */
  @Setup
  public void load() {
    expected = RESULTS.get(task);
    script = BenchmarkScript.load(task);
  }

  /** One run of the program. */
  @Benchmark
  public double run() {
    double result = script.runToEnd();
    if (!(Math.abs(result - expected) <= TOLERANCE)) {
      throw new IllegalStateException(task + ": result is " + result + ", must be " + expected);
    }
    return result;
  }
}
