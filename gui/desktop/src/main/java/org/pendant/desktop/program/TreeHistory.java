package org.pendant.desktop.program;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.pendant.project.program.ProgramTree;

/**
 * Tree history: trees as they were before each change, so that changes can be undone and done
 * again.
 */
final class TreeHistory {
  /** Changes of one field follow each other within this time while the user types. */
  private static final long MERGE_MS = 1500;

  private static final int MOST = 500;

  private final LongSupplier clockMs;
  private final Deque<Change> done = new ArrayDeque<>();
  private final Deque<Change> undone = new ArrayDeque<>();
  private long changedMs;

  /**
   * A change.
   *
   * @param what people read, such as {@code Change speed}
   * @param key of the node that it is about; 0 for none
   * @param tree before it for changes to undo, after it for those to do again
   */
  record Change(String what, long key, ProgramTree tree) {}

  /**
   * Nothing has changed yet.
   *
   * @param clockMs any clock that runs, ms
   */
  TreeHistory(LongSupplier clockMs) {
    this.clockMs = clockMs;
  }

  /**
   * A tree is about to be replaced.
   *
   * @param what people read; the same words for the same node within a short time make one change
   * @param key of the node that it is about; 0 for changes that never are one with others
   */
  void changing(String what, long key, ProgramTree before) {
    long nowMs = clockMs.getAsLong();
    Change last = done.peek();
    boolean merged =
        last != null
            && undone.isEmpty()
            && key != 0
            && last.key() == key
            && last.what().equals(what)
            && nowMs - changedMs <= MERGE_MS;
    changedMs = nowMs;
    undone.clear();
    if (!merged) {
      done.push(new Change(what, key, before));
      if (done.size() > MOST) {
        done.removeLast();
      }
    }
  }

  /** Takes the last change back; {@code now} can be had again. */
  Optional<Change> undo(ProgramTree now) {
    return turn(done, undone, now);
  }

  /** Does the change that was taken back last again. */
  Optional<Change> redo(ProgramTree now) {
    return turn(undone, done, now);
  }

  private Optional<Change> turn(Deque<Change> from, Deque<Change> to, ProgramTree now) {
    Change change = from.poll();
    if (change == null) {
      return Optional.empty();
    }
    to.push(new Change(change.what(), change.key(), now));
    changedMs = clockMs.getAsLong() - MERGE_MS - 1;
    return Optional.of(change);
  }

  /** What would be undone. */
  Optional<String> undoes() {
    return Optional.ofNullable(done.peek()).map(Change::what);
  }

  /** What would be done again. */
  Optional<String> redoes() {
    return Optional.ofNullable(undone.peek()).map(Change::what);
  }
}
