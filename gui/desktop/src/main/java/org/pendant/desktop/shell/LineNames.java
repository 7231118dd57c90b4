package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ProgramDocument;

/**
 * Line names: what lines of programs are called in a sentence: the node that a line is generated
 * from, as people who build programs of nodes know no lines, and else the line.
 */
record LineNames(TreeRuns runs, ProgramRunner runner, DebugPresenter debug) {
  /** Such as {@code node 15 Feeder} or {@code line 44}, of the program that was started last. */
  String started(int line) {
    return of(runner.program(), debug.lineNow(line));
  }

  /** The same for a line of the present text of a program. */
  String of(Optional<ProgramDocument> document, int line) {
    return runs.node(document, line).map(RunNode::words).orElse(text("line", line));
  }
}
