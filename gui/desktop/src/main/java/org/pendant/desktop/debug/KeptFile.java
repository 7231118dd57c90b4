package org.pendant.desktop.debug;

import java.util.List;
import org.pendant.desktop.editor.TextPlace;
import org.pendant.script.debug.Breakpoint;

/**
 * Kept file: what is remembered of a file until it is opened again.
 *
 * @param place where people were in it
 * @param breakpoints in the order of their lines
 */
record KeptFile(TextPlace place, List<Breakpoint> breakpoints) {

  /** The breakpoints are copied. */
  KeptFile {
    breakpoints = List.copyOf(breakpoints);
  }

  /** Whether it is what any file has that is opened the first time. */
  boolean plain() {
    return breakpoints.isEmpty() && place.equals(TextPlace.START);
  }
}
