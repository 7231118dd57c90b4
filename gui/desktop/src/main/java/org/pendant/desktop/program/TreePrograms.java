package org.pendant.desktop.program;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;

/**
 * Tree programs: the trees of the open programs that are trees. One thread uses it, the dispatch
 * thread.
 */
public final class TreePrograms {
  private final IdentityHashMap<ProgramDocument, TreeProgram> trees = new IdentityHashMap<>();

  private final Programs programs;
  private final ActiveInstallation installation;
  private final Executor worker;
  private final Executor display;
  private TreeProgram.ScriptSink sink =
      (program, before, now) -> program.document().script().setText(now.text());

  /**
   * The trees of {@code programs}.
   *
   * @param worker runs what takes long, one after the other
   * @param display runs what follows that on the dispatch thread
   */
  public TreePrograms(
      Programs programs, ActiveInstallation installation, Executor worker, Executor display) {
    this.programs = programs;
    this.installation = installation;
    this.worker = worker;
    this.display = display;
    installation.addListener(() -> trees.values().forEach(TreeProgram::check));
    programs.addListener(this::follow);
    follow();
  }

  private void follow() {
    for (ProgramDocument each : List.copyOf(trees.keySet())) {
      if (!programs.all().contains(each)) {
        each.removeListener(trees.remove(each));
      }
    }
    programs.all().forEach(this::of);
  }

  /** Has generated scripts shown there from now on. */
  public void setSink(TreeProgram.ScriptSink sink) {
    this.sink = sink;
  }

  /** The tree of a program; empty for scripts. */
  public Optional<TreeProgram> of(ProgramDocument document) {
    return document.isTree()
        ? Optional.of(trees.computeIfAbsent(document, this::make))
        : Optional.empty();
  }

  /** The tree of the program that Run runs; empty while that is a script. */
  public Optional<TreeProgram> current() {
    return of(programs.current());
  }

  private TreeProgram make(ProgramDocument document) {
    return new TreeProgram(
        document,
        installation::current,
        worker,
        display,
        (program, before, now) -> sink.show(program, before, now),
        () -> System.nanoTime() / 1_000_000);
  }
}
