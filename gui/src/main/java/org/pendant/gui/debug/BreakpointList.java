package org.pendant.gui.debug;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.pendant.controller.debug.Breakpoint;

/** The breakpoints of one program, one a line. */
final class BreakpointList {
  private final SortedMap<Integer, Breakpoint> byLine = new TreeMap<>();

  /** All of them in the order of their lines. */
  List<Breakpoint> all() {
    return List.copyOf(byLine.values());
  }

  Optional<Breakpoint> at(int line) {
    return Optional.ofNullable(byLine.get(line));
  }

  /** Sets one, in place of the one on its line. */
  void set(Breakpoint breakpoint) {
    byLine.put(breakpoint.line(), breakpoint);
  }

  /**
   * Takes over where the editor has them. Those whose line is gone have moved with the text, in
   * their order, as far as there are new lines; what is left over is new or removed.
   */
  void setLines(SortedSet<Integer> lines) {
    SortedSet<Integer> fresh = new TreeSet<>(lines);
    fresh.removeAll(byLine.keySet());
    List<Breakpoint> gone = new ArrayList<>(without(lines));
    byLine.keySet().retainAll(lines);
    int next = 0;
    for (int line : fresh) {
      set(next < gone.size() ? moved(gone.get(next), line) : Breakpoint.at(line));
      next++;
    }
  }

  private List<Breakpoint> without(Collection<Integer> lines) {
    return byLine.values().stream().filter(each -> !lines.contains(each.line())).toList();
  }

  private static Breakpoint moved(Breakpoint from, int line) {
    return new Breakpoint(line, from.enabled(), from.condition(), from.fromHit());
  }
}
