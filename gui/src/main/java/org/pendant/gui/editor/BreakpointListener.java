package org.pendant.gui.editor;

import java.util.SortedSet;
import org.pendant.gui.session.ProgramDocument;

/** Who wants to know where breakpoints are. */
public interface BreakpointListener {

  /**
   * A breakpoint was set or cleared.
   *
   * @param lines all lines of the program that have one, from 1
   */
  void breakpointsChanged(ProgramDocument program, SortedSet<Integer> lines);
}
