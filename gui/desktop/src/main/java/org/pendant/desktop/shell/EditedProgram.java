package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.debug.ProgramLaunch;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.whatif.WhatIfView;
import org.pendant.kit.background.Background;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Edited program: the program that ran last, compiled as it is edited now. */
final class EditedProgram implements WhatIfView.RanProgram {
  private final RobotSession session;
  private final Programs programs;
  private final ProgramRunner runner;
  private final TreeRuns runs;
  private final LineNames names;

  EditedProgram(
      RobotSession session,
      Programs programs,
      ProgramRunner runner,
      TreeRuns runs,
      LineNames names) {
    this.session = session;
    this.programs = programs;
    this.runner = runner;
    this.runs = runs;
    this.names = names;
  }

  @Override
  public Optional<ProgramDocument> started() {
    return runner.program().filter(programs.all()::contains);
  }

  @Override
  public ProgramDocument front() {
    return programs.current();
  }

  @Override
  public String place(ProgramDocument of, int line, boolean edited) {
    return !edited && runner.program().equals(Optional.of(of))
        ? names.started(line)
        : names.of(Optional.of(of), line);
  }

  /** Compiles it; that of the one in front if none of those that are open has run. */
  @Override
  public void compile(Consumer<Program> then, Consumer<String> failed) {
    ProgramDocument document = started().orElseGet(programs::current);
    Optional<String> why = runs.whyNot(document, 0);
    if (why.isPresent()) {
      failed.accept(Messages.told(document.name(), why.get()));
      return;
    }
    ProgramLaunch plan = runs.plan(document, 0);
    if (plan.waitingNodes() > 0) {
      failed.accept(text("waitsForTheScriptOfA", document.name()));
      return;
    }
    Background.run(
        () -> {
          Source source = plan.script().apply(Optional.empty()).source();
          return new Compiled(source, session.load(source));
        },
        compiled ->
            refusal(document, compiled)
                .ifPresentOrElse(
                    failed, () -> then.accept(compiled.loadResult().program().orElseThrow())),
        refused -> failed.accept(Messages.told(document.name(), refused.getMessage())));
  }

  /** What became of a text. */
  private record Compiled(Source source, LoadResult loadResult) {}

  /** Why it cannot run as a variant; empty if it can. */
  private Optional<String> refusal(ProgramDocument document, Compiled compiled) {
    Optional<Diagnostic> error =
        compiled.loadResult().diagnostics().stream().filter(Diagnostic::isError).findFirst();
    if (error.isPresent()) {
      int line = compiled.source().line(error.get().range().start());
      return Optional.of(
          text(
              "programPlaceAndMessage",
              document.name(),
              names.of(Optional.of(document), line),
              Messages.shown(ByteText.decoded(error.get().message()))));
    }
    return compiled.loadResult().program().orElseThrow().secondary()
        ? Optional.of(Messages.told(document.name(), text("aSecondaryProgramRunsBesideAnother")))
        : Optional.empty();
  }
}
