package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;

/** The newest events of interpreter mode. The frame loop alone writes; any thread may read. */
public final class InterpreterJournal {
  /** How many of the newest events can still be asked for. */
  public static final int KEPT = 4096;

  /** An event with its number, which counts from 1. */
  public record Entry(long number, InterpreterEvent event) {}

  private final AtomicReferenceArray<Entry> ring = new AtomicReferenceArray<>(KEPT);
  private volatile long newest;

  void add(InterpreterEvent event) {
    long number = newest + 1;
    ring.set((int) (number % KEPT), new Entry(number, event));
    newest = number;
  }

  /** The number of the newest event, 0 for none. */
  public long newest() {
    return newest;
  }

  /** Events after number {@code number} that are still kept, oldest first. */
  public List<Entry> since(long number) {
    long last = newest;
    List<Entry> found = new ArrayList<>();
    for (long each = Math.max(number, last - KEPT) + 1; each <= last; each++) {
      Entry entry = ring.get((int) (each % KEPT));
      // a slow reader may be overtaken: then a newer event stands in this place
      if (entry != null && entry.number() == each) {
        found.add(entry);
      }
    }
    return found;
  }
}
