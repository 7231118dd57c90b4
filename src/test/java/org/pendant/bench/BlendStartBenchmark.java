package org.pendant.bench;

import java.nio.charset.StandardCharsets;
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
import org.pendant.controller.Controller;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.script.vm.ProgramState;

/**
 * Frames of a program whose moves are so short that every few frames one starts and blends: the
 * next moves are looked for in the program then, and the move is planned with them. The median is a
 * frame on the way, the upper tenth are those in which a move starts.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 4, time = 1)
public class BlendStartBenchmark {
  /** Small: the loop alone. Points: they stand in a list of 5000. Big: 3000 functions around it. */
  @Param({"small", "points", "big"})
  String program;

  private Controller controller;

  /** Starts the program. */
  @Setup
  public void start() {
    byte[] text = text().getBytes(StandardCharsets.ISO_8859_1);
    BenchmarkScript script = BenchmarkScript.load(Source.of(program + ".script", text));
    script.start();
    controller = script.controller();
  }

  private String text() {
    StringBuilder text = new StringBuilder("def blends():\n");
    if (program.equals("big")) {
      for (int i = 0; i < 3000; i++) {
        text.append("  def f" + i + "(x):\n    return x + " + i + "\n  end\n");
        text.append("  g" + i + " = " + i + "\n");
      }
    }
    text.append("  points = [p[0.45, 0, 0.45, 2.2214, -2.2214, 0]");
    for (int i = 1; i < (program.equals("points") ? 5000 : 100); i++) {
      double y = 0.003 * (i % 100 < 50 ? i % 50 : 50 - i % 50);
      text.append(", p[" + (0.45 + 0.001 * (i % 2)) + ", " + y + ", 0.45, 2.2214, -2.2214, 0]");
    }
    return text.append(
            """
            ]
              i = 0
              while True:
                movel(points[i], r=0.001)
                i = (i + 1) % 100
              end
            end
            """)
        .toString();
  }

  /** One frame. */
  @Benchmark
  public ControllerState frame() {
    controller.advance();
    if (controller.state().program().state() != ProgramState.RUNNING) {
      throw new IllegalStateException("the program ended");
    }
    return controller.state();
  }
}
