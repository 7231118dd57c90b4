package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.debug.StartedProgram;
import org.pendant.desktop.log.LogPlace;
import org.pendant.desktop.log.LogPlaces;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ProgramDocument;

/**
 * Run places: what the lines of a program that ran are called, and how they are shown: the node
 * that a line is generated from, and else the line.
 */
record RunPlaces(TreeRuns runs, Consumer<RunNode> showNode, ShowLine showLine) {

  /** Shows a line, from 1, of a program as it is now. */
  @FunctionalInterface
  interface ShowLine {
    void show(ProgramDocument document, int line);
  }

  /** Those of a program that was started; none if its text is not shown. */
  LogPlaces of(StartedProgram started) {
    return (timeS, source, line) ->
        started
            .document()
            .filter(document -> source.equals(started.script().source().name()))
            .flatMap(document -> place(document, line, started.toNow(line)));
  }

  /**
   * A line of a program.
   *
   * @param line as it ran
   * @param now as it is in the present text; 0 if it is not there any more
   */
  Optional<LogPlace> place(ProgramDocument document, int line, int now) {
    if (now <= 0) {
      return Optional.empty();
    }
    return runs.node(Optional.of(document), now)
        .map(node -> new LogPlace(node.briefly(), node.words(), () -> showNode.accept(node)))
        .or(
            () ->
                Optional.of(
                    new LogPlace(
                        String.valueOf(line),
                        text("line", line),
                        () -> showLine.show(document, now))));
  }
}
