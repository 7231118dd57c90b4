package org.pendant.desktop.editor;

/**
 * Execution point: where a program is.
 *
 * @param line from 1; 0 for nowhere
 * @param note what stands after the line, such as why the program is paused; empty for nothing
 */
public record Execution(int line, State state, String note) {
  /** No line of this program runs. */
  public static final Execution NONE = new Execution(0, State.RUNNING, "");

  /** What the program does there. */
  public enum State {
    RUNNING,
    HELD,
    FAILED
  }

  /** A program that runs. */
  public static Execution running(int line) {
    return line < 1 ? NONE : new Execution(line, State.RUNNING, "");
  }
}
