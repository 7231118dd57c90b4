package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;

/** Runs one program in every form that the machine has for it. */
final class TranslationRuns {
  private static final int MAX_FRAMES = 60;
  private static final int MAX_SHORT_FRAMES = 300;
  private static final int MAX_SHORT_SLICE_NS = 400;

  /**
   * All that a program shows to the outside.
   *
   * @param threads after each frame where each thread is, and what is left of its slice
   * @param stacks after each frame the functions that each thread is in, with the next instruction
   *     and the variables
   * @param marks what was reached; empty without coverage
   */
  record Shown(
      List<String> messages,
      String ending,
      int frames,
      String globals,
      List<String> interpreterReplies,
      List<String> threads,
      List<String> stacks,
      List<Boolean> marks) {
    /** What is the same with and without coverage, which adds instructions. */
    Shown unmarked() {
      return new Shown(
          messages, ending, frames, globals, interpreterReplies, threads, List.of(), List.of());
    }
  }

  private final String text;
  private final List<String> interpretedLines;
  private final boolean covered;

  /** Decides what is left of the slices; empty for whole ones. */
  private final OptionalLong shortSlices;

  TranslationRuns(String text, List<String> interpretedLines) {
    this(text, interpretedLines, false, OptionalLong.empty());
  }

  private TranslationRuns(
      String text, List<String> interpretedLines, boolean covered, OptionalLong shortSlices) {
    this.text = text;
    this.interpretedLines = interpretedLines;
    this.covered = covered;
    this.shortSlices = shortSlices;
  }

  /** The same program, compiled for coverage. */
  TranslationRuns covered() {
    return new TranslationRuns(text, interpretedLines, true, shortSlices);
  }

  /** The same program, with slices that end after a few instructions. */
  TranslationRuns inShortSlices(long seed) {
    return new TranslationRuns(text, interpretedLines, covered, OptionalLong.of(seed));
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
    List<String> stacks = new ArrayList<>();
    Optional<Random> left = shortSlices.stream().mapToObj(Random::new).findFirst();
    int frames = left.isPresent() ? MAX_SHORT_FRAMES : MAX_FRAMES;
    while (fixture.machine.state() == ProgramState.RUNNING && fixture.frames < frames) {
      left.ifPresent(r -> fixture.machine.run().ifPresent(run -> shorten(run, r)));
      random.ifPresent(r -> translateSome(program, r));
      if (fixture.machine.interpreter().active() && replies.isEmpty()) {
        interpretedLines.forEach(line -> replies.add(fixture.submit(line)));
      }
      fixture.advance(1);
      for (ScriptThread thread : fixture.machine.run().map(ProgramRun::threads).orElse(List.of())) {
        threads.add(told(thread));
        stacks.add(stack(fixture.machine.run().orElseThrow(), thread));
      }
    }
    String ending = fixture.machine.ending().map(Ending::toString).orElse("still running");
    return new Shown(
        List.copyOf(fixture.messages),
        ending,
        fixture.frames,
        fixture.machine.globals().toString(),
        replies,
        threads,
        stacks,
        fixture.machine.coverage().map(TranslationRuns::marks).orElse(List.of()));
  }

  /** Leaves little of the next slice of each thread. */
  private static void shorten(ProgramRun run, RandomGenerator random) {
    int share = Slices.PRIMARY.computing(run.threads().size());
    for (ScriptThread thread : run.threads()) {
      thread.debtNs = Math.max(0, share - 1 - random.nextInt(MAX_SHORT_SLICE_NS));
    }
  }

  private static String stack(ProgramRun run, ScriptThread thread) {
    StringBuilder frames = new StringBuilder();
    for (int i = 0; i < thread.depth; i++) {
      ScriptFunction function = thread.functions[i];
      frames.append(function.name()).append(' ').append(thread.pcs[i]).append(' ');
      // the rest is often deep, and told by what follows
      if (i < 3 || i > thread.depth - 4) {
        for (int v = 0; v < function.variableCount(); v++) {
          int slot = thread.bases[i] + v;
          frames.append(run.registers().assigned(slot) ? run.registers().value(slot) : "-");
          frames.append(' ');
        }
      }
    }
    return frames.toString();
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
