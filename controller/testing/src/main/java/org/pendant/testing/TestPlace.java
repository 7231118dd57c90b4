package org.pendant.testing;

/**
 * Test place: where in a file something stands.
 *
 * @param file its name as it was given, or found below a folder that was given
 * @param line 1-based
 * @param column 1-based; 0 where only the line is known
 * @param function that the line is in; empty where it is not known
 */
public record TestPlace(String file, int line, int column, String function) {
  /** Such as {@code pick_test.script:12:3}. */
  public String text() {
    return column > 0 ? file + ":" + line + ":" + column : file + ":" + line;
  }
}
