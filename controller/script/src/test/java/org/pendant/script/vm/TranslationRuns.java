package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;

/** Runs one program in every form that the machine has for it. */
final class TranslationRuns {
  private static final int MAX_FRAMES = 60;

  /**
   * All that a program shows to the outside.
   *
   * @param threads after each frame where each thread is, and what is left of its slice
   * @param marks what was reached; empty without coverage
   */
  record Shown(
      List<String> messages,
      String ending,
      int frames,
      String globals,
      List<String> interpreterReplies,
      List<String> threads,
      List<Boolean> marks) {
    /** What there is to see without coverage. */
    Shown unmarked() {
      return new Shown(messages, ending, frames, globals, interpreterReplies, threads, List.of());
    }
  }

  private final String text;
  private final List<String> interpretedLines;
  private final boolean covered;

  TranslationRuns(String text, List<String> interpretedLines) {
    this(text, interpretedLines, false);
  }

  private TranslationRuns(String text, List<String> interpretedLines, boolean covered) {
    this.text = text;
    this.interpretedLines = interpretedLines;
    this.covered = covered;
  }

  /** The same program, compiled for coverage. */
  TranslationRuns covered() {
    return new TranslationRuns(text, interpretedLines, true);
  }

  /** Whether the checker accepts the program. */
  boolean valid() {
    LoadResult loadResult =
        ProgramLoader.load(Source.of("test", text), new MachineFixture().builtins);
    return loadResult.program().isPresent();
  }

  Shown interpreted() {
    return run(Translation.NEVER, Optional.empty());
  }

  Shown translated() {
    return run(Translation.ALWAYS, Optional.empty());
  }

  /** Translates functions at random before and between the frames. */
  Shown mixed(RandomGenerator random) {
    return run(Translation.WHEN_HOT, Optional.of(random));
  }

  private Shown run(Translation translation, Optional<RandomGenerator> random) {
    MachineFixture fixture = new MachineFixture(translation);
    Program program = covered ? fixture.compileCovered(text) : fixture.compile(text);
    fixture.machine.start(program);
    List<String> replies = new ArrayList<>();
    List<String> threads = new ArrayList<>();
    while (fixture.machine.state() == ProgramState.RUNNING && fixture.frames < MAX_FRAMES) {
      random.ifPresent(r -> translateSome(program, r));
      if (fixture.machine.interpreter().active() && replies.isEmpty()) {
        interpretedLines.forEach(line -> replies.add(fixture.submit(line)));
      }
      fixture.advance(1);
      fixture.machine.run().ifPresent(run -> run.threads().forEach(t -> threads.add(told(t))));
    }
    String ending = fixture.machine.ending().map(Ending::toString).orElse("still running");
    return new Shown(
        List.copyOf(fixture.messages),
        ending,
        fixture.frames,
        fixture.machine.globals().toString(),
        replies,
        threads,
        fixture.machine.coverage().map(TranslationRuns::marks).orElse(List.of()));
  }

  private static String told(ScriptThread thread) {
    return String.join(
        " ",
        thread.id() + ":",
        thread.state.toString(),
        "line " + thread.line(),
        thread.budget + " ns",
        thread.debtNs + " ns owed");
  }

  private static List<Boolean> marks(Coverage coverage) {
    return coverage.map().sites().stream()
        .flatMap(
            site ->
                site.kind().twoWay()
                    ? Stream.of(coverage.reached(site, false), coverage.reached(site, true))
                    : Stream.of(coverage.reached(site)))
        .toList();
  }

  private static void translateSome(Program program, RandomGenerator random) {
    for (ScriptFunction function : program.tables().functions()) {
      if (function.translated() == null && random.nextInt(4) == 0) {
        Translator.translate(function, program.tables()).ifPresent(function::install);
      }
    }
  }
}
