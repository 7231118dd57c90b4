package org.pendant.testing;

/**
 * Test id: which test it is.
 *
 * @param file the file that it stands in, as it was given, or found below a folder that was given
 * @param function its name, such as {@code test_grip}
 * @param row which row of a table of cases, as text such as {@code [0.5, True]}; empty for a test
 *     without a table
 */
public record TestId(String file, String function, String row) {
  /** Its name within its file: {@code test_grip} or {@code test_grip[0.5, True]}. */
  public String name() {
    return row.isEmpty() ? function : function + row;
  }
}
