package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.debug.ProgramLaunch;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.whatif.WhatIfView;
import org.pendant.kit.background.Background;
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

  EditedProgram(RobotSession session, Programs programs, ProgramRunner runner, TreeRuns runs) {
    this.session = session;
    this.programs = programs;
    this.runner = runner;
    this.runs = runs;
  }

  @Override
  public Optional<ProgramDocument> started() {
    return runner.program().filter(programs.all()::contains);
  }

  @Override
  public ProgramDocument front() {
    return programs.current();
  }

  /** Compiles it; that of the one in front if none of those that are open has run. */
  @Override
  public void compile(Consumer<Program> then, Consumer<String> failed) {
    ProgramDocument document = started().orElseGet(programs::current);
    Optional<String> why = runs.whyNot(document, 0);
    if (why.isPresent()) {
      failed.accept(document.name() + ": " + why.get());
      return;
    }
    ProgramLaunch plan = runs.plan(document, 0);
    if (plan.waitingNodes() > 0) {
      failed.accept(text("waitsForTheScriptOfA", document.name()));
      return;
    }
    Background.run(
        () -> compiled(plan.script().apply(Optional.empty()).source()),
        then,
        refused -> failed.accept(document.name() + ": " + refused.getMessage()));
  }

  private Program compiled(Source source) throws IOException {
    LoadResult loadResult = session.load(source);
    Optional<Diagnostic> error =
        loadResult.diagnostics().stream().filter(Diagnostic::isError).findFirst();
    if (error.isPresent()) {
      int line = source.line(error.get().range().start());
      throw new IOException(text("lineAndMessage", line, ByteText.decoded(error.get().message())));
    }
    Program program = loadResult.program().orElseThrow();
    if (program.secondary()) {
      throw new IOException(text("aSecondaryProgramRunsBesideAnother"));
    }
    return program;
  }
}
