package org.pendant.desktop.editor;

/**
 * Line cover: what tests have reached of a line.
 *
 * @param stale whether the text was edited since
 * @param about it, in one short line
 * @param whole all that is known, a line each
 */
public record LineCover(Reach reach, boolean stale, String about, String whole) {

  /** How much of a line. */
  public enum Reach {
    /** All that is on it. */
    ALL,
    /** Not every statement, or not every way of a condition. */
    SOME,
    /** Nothing. */
    NONE
  }
}
