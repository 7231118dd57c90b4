package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.ToIntFunction;
import java.util.function.ToLongFunction;

/**
 * Recent entries: the newest of what is numbered from 1 without gaps, as many as fit into a bound.
 * One thread adds; any thread may read at any time.
 */
public final class RecentEntries<T> {
  private final AtomicReferenceArray<T> ring;
  private final long mostBytes;
  private final ToLongFunction<T> number;
  private final ToIntFunction<T> size;
  private long bytes;
  private long oldest = 1;
  private volatile long newest;

  /**
   * Nothing yet.
   *
   * @param most how many entries are kept
   * @param mostBytes what they may take together; the newest one is kept in any case
   * @param number of an entry
   * @param size of an entry, bytes
   */
  public RecentEntries(int most, long mostBytes, ToLongFunction<T> number, ToIntFunction<T> size) {
    ring = new AtomicReferenceArray<>(most);
    this.mostBytes = mostBytes;
    this.number = number;
    this.size = size;
  }

  /** Adds the entry with number {@link #newest} + 1; the oldest ones go if there is no room. */
  public void add(T entry) {
    long next = number.applyAsLong(entry);
    bytes += size.applyAsInt(entry);
    while (oldest < next && (next - oldest >= ring.length() || bytes > mostBytes)) {
      bytes -= size.applyAsInt(ring.getAndSet(place(oldest), null));
      oldest++;
    }
    ring.set(place(next), entry);
    newest = next;
  }

  /** The number of the newest entry, 0 for none. */
  public long newest() {
    return newest;
  }

  /** Entries after number {@code after} up to {@code last} that are still kept, oldest first. */
  public List<T> between(long after, long last) {
    long end = Math.min(last, newest);
    List<T> found = new ArrayList<>();
    for (long each = Math.max(after, end - ring.length()) + 1; each <= end; each++) {
      T entry = ring.get(place(each));
      // a slow reader may be overtaken: then a newer entry stands in this place, or none
      if (entry != null && number.applyAsLong(entry) == each) {
        found.add(entry);
      }
    }
    return found;
  }

  private int place(long each) {
    return (int) (each % ring.length());
  }
}
