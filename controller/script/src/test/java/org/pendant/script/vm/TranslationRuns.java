package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.pendant.language.source.Source;

/** Runs one program in every form that the machine has for it. */
final class TranslationRuns {
  private static final int MAX_FRAMES = 60;

  /** All that a program shows to the outside. */
  record Shown(
      List<String> messages,
      String ending,
      int frames,
      String globals,
      List<String> interpreterReplies) {}

  private final String text;
  private final List<String> interpretedLines;

  TranslationRuns(String text, List<String> interpretedLines) {
    this.text = text;
    this.interpretedLines = interpretedLines;
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
    Program program = fixture.compile(text);
    fixture.machine.start(program);
    List<String> replies = new ArrayList<>();
    while (fixture.machine.state() == ProgramState.RUNNING && fixture.frames < MAX_FRAMES) {
      random.ifPresent(r -> translateSome(program, r));
      if (fixture.machine.interpreter().active() && replies.isEmpty()) {
        interpretedLines.forEach(line -> replies.add(fixture.submit(line)));
      }
      fixture.advance(1);
    }
    String ending = fixture.machine.ending().map(Ending::toString).orElse("still running");
    return new Shown(
        List.copyOf(fixture.messages),
        ending,
        fixture.frames,
        fixture.machine.globals().toString(),
        replies);
  }

  private static void translateSome(Program program, RandomGenerator random) {
    for (ScriptFunction function : program.tables().functions()) {
      if (function.translated() == null && random.nextInt(4) == 0) {
        Translator.translate(function, program.tables()).ifPresent(function::install);
      }
    }
  }
}
