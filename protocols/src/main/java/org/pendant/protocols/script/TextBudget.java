package org.pendant.protocols.script;

import java.util.concurrent.atomic.AtomicLong;

/** Text budget: how much unfinished text all clients together may leave with a box. Any thread. */
final class TextBudget {
  /** Bytes that all unfinished texts may take together. */
  static final long CAPACITY = 64L << 20;

  private final AtomicLong left = new AtomicLong(CAPACITY);

  /** Takes {@code bytes} out of it; whether there were so many. */
  boolean take(int bytes) {
    if (left.addAndGet(-bytes) < 0) {
      left.addAndGet(bytes);
      return false;
    }
    return true;
  }

  /** Gives back what was taken. */
  void giveBack(int bytes) {
    left.addAndGet(bytes);
  }
}
