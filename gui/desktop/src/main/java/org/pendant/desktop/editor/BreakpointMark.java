package org.pendant.desktop.editor;

/**
 * Breakpoint mark: how a breakpoint is shown beside its line.
 *
 * @param enabled whether it stops the program just now
 * @param conditional whether it stops it only sometimes
 * @param about when it stops the program, a sentence without its full stop
 */
public record BreakpointMark(boolean enabled, boolean conditional, String about) {
  /** One that always stops. */
  public static final BreakpointMark PLAIN =
      new BreakpointMark(true, false, "The program stops before this line");
}
