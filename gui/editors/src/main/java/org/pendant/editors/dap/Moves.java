package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.script.vm.Program;

/**
 * Moves of a program: where it leads the arm somewhere. What a program does each frame, such as
 * {@code servoj}, is none.
 *
 * @param lines of the statements that do so, counted from 1
 */
record Moves(Set<Integer> lines) {
  /** The functions that lead the arm to a target. */
  static final Set<String> FUNCTIONS =
      Set.of("movej", "movel", "movep", "movec", "optimovej", "optimovel", "mc_run_motion");

  Moves {
    lines = Set.copyOf(lines);
  }

  static Moves of(Program program) {
    return new Moves(
        program.statementsCalling(FUNCTIONS).stream()
            .map(program.source()::line)
            .collect(Collectors.toSet()));
  }

  /** What is said, within a sentence, of a program that has stepped to {@code line} by a move. */
  String words(int line) {
    return lines.contains(line) ? text("moveBegins") : text("moveEnded");
  }
}
