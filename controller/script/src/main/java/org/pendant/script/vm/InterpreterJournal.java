package org.pendant.script.vm;

import java.util.List;

/**
 * Interpreter journal: the newest events of interpreter mode. The frame loop alone writes; any
 * thread may read.
 */
public final class InterpreterJournal {
  /** How many of the newest events can still be asked for. */
  public static final int KEPT = 4096;

  /** What the events that can be asked for take together, at most, bytes. */
  public static final int KEPT_BYTES = 8 << 20;

  /** An event with its number, which counts from 1. */
  public record Entry(long number, InterpreterEvent event) {}

  private final RecentEntries<Entry> recent =
      new RecentEntries<>(KEPT, KEPT_BYTES, Entry::number, each -> each.event().bytes());

  void add(InterpreterEvent event) {
    recent.add(new Entry(recent.newest() + 1, event));
  }

  /** The number of the newest event, 0 for none. */
  public long newest() {
    return recent.newest();
  }

  /** Events after number {@code number} that are still kept, oldest first. */
  public List<Entry> since(long number) {
    return recent.between(number, Long.MAX_VALUE);
  }
}
