package org.pendant.project.program.text;

/** Text error: a line that cannot be understood. */
public final class WrongText extends Exception {
  private static final long serialVersionUID = 1;

  private final int column;

  /**
   * @param column where it is wrong, in characters from 1
   * @param message what was found and what would be right
   */
  public WrongText(int column, String message) {
    super(message, null, false, false);
    this.column = column;
  }

  public int column() {
    return column;
  }
}
