package org.pendant.bench;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.language.source.Source;

/** A minute of robot work in virtual time: a new controller, loading the program, running it. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 3, time = 1)
public class VirtualTimeBenchmark {
  private Source source;

  /** Reads the file. */
  @Setup
  public void read() {
    source = BenchmarkScript.source("minute");
  }

  /**
   * The whole minute.
   *
   * @return virtual time at its end, s
   */
  @Benchmark
  public double minute() {
    BenchmarkScript script = BenchmarkScript.load(source);
    script.runToEnd();
    double timeS = script.controller().state().timeS();
    if (timeS < 60 || timeS > 70) {
      throw new IllegalStateException("the program took " + timeS + " s, must take a minute");
    }
    return timeS;
  }
}
