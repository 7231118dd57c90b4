package org.pendant.script.debug;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.script.vm.Program;

/** Breakpoints of a debugger, one a line, and the statements of the running program they mean. */
final class Breakpoints {
  /** A breakpoint while a program runs. */
  static final class Entry {
    private final Breakpoint breakpoint;
    private final LogMessage message;
    private OptionalInt start = OptionalInt.empty();
    private long hits;

    private Entry(Breakpoint breakpoint) {
      this.breakpoint = breakpoint;
      message = LogMessage.of(breakpoint.message());
    }

    Breakpoint breakpoint() {
      return breakpoint;
    }

    /** What it writes instead of stopping. */
    LogMessage message() {
      return message;
    }

    /** Counts a hit; returns how many there have been. */
    long countHit() {
      return ++hits;
    }

    private void bind(Optional<Program> program) {
      start =
          program.map(each -> each.statementFrom(breakpoint.line())).orElse(OptionalInt.empty());
    }
  }

  private final SortedMap<Integer, Entry> entries = new TreeMap<>();
  private Optional<Program> program = Optional.empty();

  /** Begins to count for a run of {@code program}. */
  void bind(Program program) {
    this.program = Optional.of(program);
    for (Entry entry : entries.values()) {
      entry.bind(this.program);
      entry.hits = 0;
    }
  }

  /** Adds a breakpoint, in place of the one on its line. Its hits are kept. */
  BreakpointState set(Breakpoint breakpoint) {
    Entry entry = new Entry(breakpoint);
    entry.bind(program);
    Entry before = entries.put(breakpoint.line(), entry);
    entry.hits = before == null ? 0 : before.hits;
    return state(entry);
  }

  boolean remove(int line) {
    return entries.remove(line) != null;
  }

  void removeAll() {
    entries.clear();
  }

  /** All of them by line. */
  List<BreakpointState> states() {
    return entries.values().stream().map(this::state).toList();
  }

  private BreakpointState state(Entry entry) {
    OptionalInt line =
        entry.start.isPresent()
            ? OptionalInt.of(program.orElseThrow().source().line(entry.start.getAsInt()))
            : OptionalInt.empty();
    return new BreakpointState(entry.breakpoint, line, entry.hits);
  }

  /** The first offsets of the statements that have an enabled one. */
  Set<Integer> starts() {
    Set<Integer> starts = new HashSet<>();
    for (Entry entry : entries.values()) {
      if (entry.breakpoint.enabled()) {
        entry.start.ifPresent(starts::add);
      }
    }
    return starts;
  }

  /** The enabled ones of the statement that begins at {@code start}. */
  List<Entry> at(int start) {
    List<Entry> found = new ArrayList<>();
    for (Entry entry : entries.values()) {
      if (entry.breakpoint.enabled() && entry.start.equals(OptionalInt.of(start))) {
        found.add(entry);
      }
    }
    return found;
  }
}
