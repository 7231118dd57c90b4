package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.language.source.Source;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.replay.SwitchOn;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantRun;
import org.pendant.script.vm.Program;

final class WhatIfPresenterTest {
  private final ControllerOptions options = ControllerOptions.headless();
  private final Journal journal = Journal.of(new Controller(options));
  private final Queue<Runnable> work = new ArrayDeque<>();
  private Optional<String> compileError = Optional.empty();
  private String refusal = "";
  private final WhatIfPresenter presenter =
      new WhatIfPresenter(
          new Runs(),
          () -> new WhatIfPresenter.Start(OptionalLong.empty(), "Run from the start", refusal),
          Runnable::run,
          work::add,
          () -> {});

  private final class Runs implements WhatIfPresenter.Source {
    @Override
    public VariantRun begin(OptionalLong frame, Variant variant, VariantLimits limits)
        throws RerunRefused {
      return VariantRun.fromStart(
          ParkedRuns.none(journal.run(), SwitchOn.of(options, journal.controller().builtins())),
          0,
          variant,
          limits);
    }

    @Override
    public void compile(Consumer<Program> then, Consumer<String> failed) {
      compileError.ifPresentOrElse(failed, () -> then.accept(program("sleep(0.1)")));
    }
  }

  private Program program(String text) {
    String whole = "def prog():\n" + text + "\nend\n";
    return journal
        .controller()
        .load(Source.of("play.script", whole.getBytes(StandardCharsets.ISO_8859_1)))
        .program()
        .orElseThrow();
  }

  private void play() {
    var _ = journal.controller().submit(new ProgramCommand.StartProgram(program("sleep(0.2)")));
    for (int i = 0; i < 200; i++) {
      journal.controller().advance();
    }
  }

  private String results() {
    return presenter.results().stream().map(ResultWords::state).toList().toString();
  }

  @Test
  void variantsRunOneAfterTheOtherElsewhere() {
    play();
    presenter.add();
    presenter.run();
    assertEquals("[waits, waits, waits]", results());
    assertTrue(presenter.running());
    assertFalse(presenter.canAdd());
    work.remove().run();
    assertFalse(presenter.running());
    assertEquals("[Finished, Finished, Finished]", results());
    assertEquals(
        0.1, presenter.results().get(2).finished().orElseThrow().cycleS().orElseThrow(), 0.005);
    presenter.clear();
    assertEquals("[, , ]", results());
  }

  @Test
  void aTextThatCannotRunLeavesTheOthers() {
    play();
    compileError = Optional.of("line 3: no");
    presenter.add();
    presenter.run();
    work.remove().run();
    assertEquals("[Finished, Finished, line 3: no]", results());
  }

  @Test
  void aRefusedRerunIsTold() {
    presenter.run();
    work.remove().run();
    assertEquals("[no program has been started yet, no program has been started yet]", results());
  }

  @Test
  void nothingRunsWhereNothingCanBegin() {
    refusal = "No program has run yet";
    presenter.run();
    assertTrue(work.isEmpty());
    assertEquals("No program has run yet", presenter.whyNot());
  }

  @Test
  void whatIsGivenUpHasNoResult() {
    play();
    presenter.run();
    presenter.cancel();
    work.remove().run();
    assertEquals("[, ]", results());
    assertFalse(presenter.running());
  }

  @Test
  void aChangeDropsWhatCameOfTheRow() {
    play();
    presenter.run();
    work.remove().run();
    presenter.change(0, presenter.rows().get(0).named("other"));
    presenter.change(1, presenter.rows().get(1).withSpeed("30"));
    assertEquals("[Finished, ]", results());
  }

  @Test
  void thereIsAlwaysOneAndNeverMoreThanFour() {
    for (int i = 0; i < 5; i++) {
      presenter.add();
    }
    assertEquals(WhatIfPresenter.MOST, presenter.rows().size());
    for (int i = 0; i < 5; i++) {
      presenter.remove(0);
    }
    assertEquals(1, presenter.rows().size());
  }
}
