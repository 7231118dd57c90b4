package org.pendant.project.program.text;

import java.util.List;
import org.pendant.project.program.ProgramTree;

/**
 * Program as it was read.
 *
 * @param tree what could be understood
 * @param problems what could not, in the order of the lines; the tree is the whole program only if
 *     there are none
 */
public record ReadProgram(ProgramTree tree, List<TextProblem> problems) {
  public ReadProgram {
    problems = List.copyOf(problems);
  }
}
