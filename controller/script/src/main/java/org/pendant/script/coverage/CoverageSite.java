package org.pendant.script.coverage;

import org.pendant.language.source.SourceRange;

/**
 * Coverage site: a place of a program that a run can reach.
 *
 * @param kind what it is
 * @param range in the source: a statement without its blocks, the name of a function, a condition
 * @param line where it begins, 1-based
 * @param function the function or thread that it belongs to; empty for the main level of a program
 *     that has no name
 * @param slot its mark, or the first of two: for {@code False}, then for {@code True}
 */
public record CoverageSite(Kind kind, SourceRange range, int line, String function, int slot) {
  /** What a site is. */
  public enum Kind {
    /** A function or thread: reached when its first statement begins. */
    FUNCTION,
    /** A statement, or the condition of an {@code elif}: reached when it begins. */
    STATEMENT,
    /** The condition of an {@code if}, {@code elif} or {@code while}: either way is reached. */
    BRANCH,
    /** An operand of {@code and} or {@code or}: either truth is reached. */
    CONDITION;

    /** Whether it has a way for False and one for True. */
    public boolean twoWay() {
      return this == BRANCH || this == CONDITION;
    }
  }
}
