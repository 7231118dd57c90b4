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
import org.pendant.language.check.Checker;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;

/** From the text of a program of 1 MB to its diagnostics, and to a program that can start. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class LanguageBenchmark {
  private Source source;
  private Builtins<?> builtins;

  /** Writes the program. */
  @Setup
  public void write() {
    source = Source.of("generated.script", GeneratedProgram.ofBytes(1_000_000));
    builtins = StandardBuiltins.create();
  }

  /** Text to tree. */
  @Benchmark
  public ParseResult parse() {
    ParseResult parsed = ScriptParser.parseProgram(source);
    requireNoErrors(parsed.diagnostics());
    return parsed;
  }

  /** Text to diagnostics, as {@code pendant check} and editors do it. */
  @Benchmark
  public List<Diagnostic> parseAndCheck() {
    List<Diagnostic> diagnostics = Checker.check(ProgramForm.of(parse().script()), builtins);
    requireNoErrors(diagnostics);
    return diagnostics;
  }

  /** Text to instructions, as {@code pendant run} does it. */
  @Benchmark
  public LoadResult load() {
    LoadResult loadResult = ProgramLoader.load(source, builtins);
    requireNoErrors(loadResult.diagnostics());
    return loadResult;
  }

  private static void requireNoErrors(List<Diagnostic> diagnostics) {
    for (Diagnostic diagnostic : diagnostics) {
      if (diagnostic.isError()) {
        throw new IllegalStateException("the generated program is wrong: " + diagnostic);
      }
    }
  }
}
