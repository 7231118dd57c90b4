package org.pendant.script.vm;

import java.util.List;
import java.util.Optional;

/**
 * Program label: a label line of a program ({@code $ 2 "MoveJ"}, manual 11), by which PolyScope
 * finds the node of its tree that a program is at.
 *
 * @param line where it stands, 1-based
 * @param number of the node
 * @param text bytes, one {@code char} a byte
 */
public record ProgramLabel(int line, int number, String text) {

  /**
   * The label that a program has passed last, in the order of its text.
   *
   * @param labels in the order of their lines
   * @param line 1-based
   */
  public static Optional<ProgramLabel> at(List<ProgramLabel> labels, int line) {
    int passed = 0;
    while (passed < labels.size() && labels.get(passed).line() <= line) {
      passed++;
    }
    return passed == 0 ? Optional.empty() : Optional.of(labels.get(passed - 1));
  }
}
