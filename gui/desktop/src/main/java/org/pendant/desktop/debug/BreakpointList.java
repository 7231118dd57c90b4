package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import org.pendant.script.debug.Breakpoint;

/** Breakpoint list: the breakpoints of one program, one a line. */
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

  /** Moves each to the line that its own has become; those that are not named go. */
  void move(SortedMap<Integer, Integer> moves) {
    List<Breakpoint> before = all();
    byLine.clear();
    for (Breakpoint each : before) {
      Integer line = moves.get(each.line());
      if (line != null) {
        byLine.putIfAbsent(line, each.onLine(line));
      }
    }
  }

  /** Takes over which lines have one; whether that is news. */
  boolean setLines(SortedSet<Integer> lines) {
    if (byLine.keySet().equals(lines)) {
      return false;
    }
    byLine.keySet().retainAll(lines);
    lines.forEach(line -> byLine.computeIfAbsent(line, Breakpoint::at));
    return true;
  }
}
