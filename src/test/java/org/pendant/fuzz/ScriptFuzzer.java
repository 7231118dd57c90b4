package org.pendant.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.FormatOptions;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;

/**
 * Reads, checks and compiles random texts, and runs the right ones of another kind. Each text and
 * program comes from one number, its seed, and can be made again from it.
 *
 * <p>CONTRIBUTING.md says how the long run is started; ScriptFuzzTest is the short one.
 */
final class ScriptFuzzer {
  /** One more than the parser reports, and one sum. The checker has no bound but the text. */
  private static final int MAX_SYNTAX_ERRORS = 51;

  /** One text of so many is handed to the editor's questions too, which read it again and again. */
  private static final int TEXTS_PER_EDITED_ONE = 20;

  private final Builtins<ControlBox> builtins = StandardBuiltins.create();
  private final AtomicInteger compiled = new AtomicInteger();

  /**
   * The long run.
   *
   * @param words how many texts, by default a million; how many programs to run, by default one for
   *     a hundred texts; and the first seed, by default 0
   */
  public static void main(String[] words) {
    long texts = words.length > 0 ? Long.parseLong(words[0]) : 1_000_000;
    long programs = words.length > 1 ? Long.parseLong(words[1]) : texts / 100;
    long first = words.length > 2 ? Long.parseLong(words[2]) : 0;
    ScriptFuzzer fuzzer = new ScriptFuzzer();
    List<String> faults = fuzzer.read(first, texts);
    System.out.printf(
        "%,d texts from seed %d, %,d compile, %d faults%n",
        texts, first, fuzzer.compiled.get(), faults.size());
    List<String> failed = fuzzer.run(first, programs);
    System.out.printf("%,d programs run, %d faults%n", programs, failed.size());
    faults.forEach(System.out::println);
    failed.forEach(System.out::println);
    System.exit(faults.isEmpty() && failed.isEmpty() ? 0 : 1);
  }

  /** The faults of the first few texts that have some, with seed and text. */
  List<String> read(long first, long texts) {
    return LongStream.range(first, first + texts)
        .parallel()
        .mapToObj(this::read)
        .flatMap(Optional::stream)
        .limit(20)
        .toList();
  }

  /** The faults of the first few programs that have some, with seed and text. */
  List<String> run(long first, long programs) {
    return LongStream.range(first, first + programs)
        .parallel()
        .mapToObj(this::run)
        .flatMap(Optional::stream)
        .limit(20)
        .toList();
  }

  private Optional<String> read(long seed) {
    byte[] text = text(new SplittableRandom(seed));
    Source source = Source.of("seed" + seed, text);
    try {
      return fault(source, seed % TEXTS_PER_EDITED_ONE == 0)
          .map(fault -> told(seed, fault, source));
    } catch (RuntimeException | StackOverflowError broken) {
      return Optional.of(told(seed, Faults.trace(broken), source));
    }
  }

  private static byte[] text(SplittableRandom random) {
    Mutations mutations = new Mutations(random);
    List<String> right = new GrammarText(random).statements(random.nextInt(3));
    return mutations.bytes(mutations.layout(mutations.tokens(right)));
  }

  private Optional<String> fault(Source source, boolean edited) {
    LoadResult loadResult = ProgramLoader.load(source, builtins);
    if (loadResult.program().isPresent()) {
      compiled.incrementAndGet();
    } else if (loadResult.diagnostics().isEmpty()) {
      return Optional.of("neither a program nor a reason");
    }
    long syntaxErrors =
        loadResult.diagnostics().stream()
            .filter(each -> each.wireText().startsWith("syntax_error"))
            .count();
    if (syntaxErrors > MAX_SYNTAX_ERRORS) {
      return Optional.of(syntaxErrors + " syntax errors");
    }
    for (Diagnostic diagnostic : loadResult.diagnostics()) {
      if (diagnostic.range().end() > source.text().length()) {
        return Optional.of("beyond the end of the text: " + diagnostic);
      }
      if (DiagnosticFormat.format(source, diagnostic).length() > 20_000) {
        return Optional.of("a message too long: " + diagnostic);
      }
    }
    if (edited) {
      edit(source);
    }
    return Optional.empty();
  }

  private void edit(Source source) {
    ScriptAnalysis analysis = ScriptAnalysis.of(source, builtins);
    analysis.outline();
    analysis.folding();
    analysis.highlighting();
    analysis.breakpointLines();
    analysis.format(FormatOptions.DEFAULT);
    analysis.diagnostics().forEach(analysis::fixes);
  }

  private Optional<String> run(long seed) {
    String text = new RandomProgram(new SplittableRandom(seed), builtins).text();
    Source source = Source.of("seed" + seed, text.getBytes(StandardCharsets.ISO_8859_1));
    try {
      return Faults.ofRun(source, builtins).map(fault -> told(seed, fault, source));
    } catch (RuntimeException | StackOverflowError broken) {
      return Optional.of(told(seed, Faults.trace(broken), source));
    }
  }

  private static String told(long seed, String fault, Source source) {
    return "seed " + seed + ": " + fault + "\n" + Faults.visible(source.text()) + "\n";
  }
}
