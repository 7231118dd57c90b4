package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

/**
 * Breakpoint mark: how a breakpoint is shown beside its line.
 *
 * @param enabled whether it does anything just now
 * @param about when it stops the program or what it writes, a sentence without its full stop
 */
public record BreakpointMark(boolean enabled, LineIcon.Kind kind, String about) {
  /** One that always stops. */
  public static final BreakpointMark PLAIN =
      new BreakpointMark(true, LineIcon.Kind.STOP, text("theProgramStopsBeforeThisLine"));
}
