package org.pendant.desktop.editor;

import java.util.SortedMap;
import java.util.SortedSet;
import org.pendant.desktop.session.ProgramDocument;

/** Breakpoint listener: is told where breakpoints are. */
public interface BreakpointListener {

  /**
   * Lines with breakpoints have moved; {@link #breakpointsChanged} follows.
   *
   * @param moves where each line with a breakpoint is now, by where it was; all of them
   */
  void breakpointsMoved(ProgramDocument program, SortedMap<Integer, Integer> moves);

  /**
   * A breakpoint was set or cleared.
   *
   * @param lines all lines of the program that have one, from 1
   */
  void breakpointsChanged(ProgramDocument program, SortedSet<Integer> lines);
}
