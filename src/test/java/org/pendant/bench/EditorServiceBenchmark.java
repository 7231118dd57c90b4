package org.pendant.bench;

import java.util.List;
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
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.Completion;
import org.pendant.language.service.FormatOptions;
import org.pendant.language.service.FormatResult;
import org.pendant.language.service.HighlightToken;
import org.pendant.language.service.Highlighting;
import org.pendant.language.service.RenameResult;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;

/** What an editor asks while a user types in a program of 5,000 lines. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class EditorServiceBenchmark {
  private static final int LINES = 5_000;

  private Builtins<?> builtins;
  private Source source;
  private Source broken;
  private ScriptAnalysis analysis;
  private int middle;

  /** Writes the program, and the same with an open call in its middle. */
  @Setup
  public void write() {
    builtins = StandardBuiltins.create();
    String text = withLines();
    source = Source.of("generated.script", text);
    middle = text.indexOf("total = total", text.length() / 2);
    String typed = text.substring(0, middle) + "movej(tot\n" + text.substring(middle);
    broken = Source.of("broken.script", typed);
    analysis = ScriptAnalysis.of(source, builtins);
    if (source.lineCount() < LINES || !analysis.diagnostics().isEmpty()) {
      throw new IllegalStateException(
          source.lineCount() + " lines, wrong: " + analysis.diagnostics());
    }
  }

  /** The text in colours, as after every keystroke. */
  @Benchmark
  public List<HighlightToken> highlight() {
    return Highlighting.of(source, builtins);
  }

  /** Parsed, checked, every name resolved. */
  @Benchmark
  public ScriptAnalysis analyse() {
    return ScriptAnalysis.of(source, builtins);
  }

  /** The same for a text with a syntax error, which is read twice. */
  @Benchmark
  public ScriptAnalysis analyseBroken() {
    return ScriptAnalysis.of(broken, builtins);
  }

  /** What may be typed in the middle. */
  @Benchmark
  public List<Completion> complete() {
    return analysis.completions(middle + 3);
  }

  /** The edits of a text that is laid out already. */
  @Benchmark
  public FormatResult format() {
    return analysis.format(FormatOptions.DEFAULT);
  }

  /** A variable gets a new name, with the proof that no other changes its meaning. */
  @Benchmark
  public RenameResult rename() {
    return analysis.rename(middle, "sum_of_all");
  }

  private static String withLines() {
    int bytes = 100_000;
    String text = GeneratedProgram.ofBytes(bytes);
    while (text.lines().count() < LINES) {
      bytes += 5_000;
      text = GeneratedProgram.ofBytes(bytes);
    }
    return text;
  }
}
