package org.pendant.protocols.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Outbox: what is sent to one peer. It goes out at once, in the sender's thread, as far as the
 * peer's window has room; the rest waits here, with a bound on its bytes, for a thread that carries
 * it out.
 */
final class Outbox {
  /** Most bytes that wait. */
  static final int CAPACITY = 1 << 20;

  /** Where bytes go. */
  @FunctionalInterface
  interface Sink {
    /** Writes what it takes without waiting. */
    int write(ByteBuffer bytes) throws IOException;
  }

  private final Sink sink;
  private final Consumer<byte[]> taken;
  private final LongSupplier nanoTime;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Queue<ByteBuffer> waiting = new ArrayDeque<>();
  private int bytes;
  private boolean closed;
  private long takenNs;

  /**
   * Nothing waits.
   *
   * @param taken is told of every message for which there is room, in their order and before the
   *     peer can have it; must not wait
   * @param nanoTime a clock, ns
   */
  Outbox(Sink sink, Consumer<byte[]> taken, LongSupplier nanoTime) {
    this.sink = sink;
    this.taken = taken;
    this.nanoTime = nanoTime;
    takenNs = nanoTime.getAsLong();
  }

  /**
   * Sends a message, or puts it at the end.
   *
   * @return whether there was room
   * @throws IOException if the sink fails
   */
  boolean offer(byte[] message) throws IOException {
    lock.lock();
    try {
      if (closed || bytes + message.length > CAPACITY) {
        return false;
      }
      taken.accept(message);
      ByteBuffer rest = ByteBuffer.wrap(message);
      if (waiting.isEmpty()) {
        write(rest);
      }
      if (rest.hasRemaining()) {
        bytes += rest.remaining();
        waiting.add(rest);
        changed.signal();
      }
      return true;
    } finally {
      lock.unlock();
    }
  }

  private void write(ByteBuffer rest) throws IOException {
    if (sink.write(rest) > 0) {
      takenNs = nanoTime.getAsLong();
    }
  }

  /**
   * Waits until something waits.
   *
   * @return false when the outbox is closed and empty
   */
  boolean awaitWaiting() throws InterruptedException {
    lock.lock();
    try {
      while (waiting.isEmpty() && !closed) {
        changed.await();
      }
      return !waiting.isEmpty();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Writes what the sink takes.
   *
   * @return whether nothing waits any more
   * @throws IOException if the sink fails
   */
  boolean writeWaiting() throws IOException {
    lock.lock();
    try {
      for (ByteBuffer next = waiting.peek(); next != null; next = waiting.peek()) {
        int before = next.remaining();
        write(next);
        bytes -= before - next.remaining();
        if (next.hasRemaining()) {
          return false;
        }
        waiting.remove();
      }
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Nothing more comes; what waits still goes out. */
  void close() {
    lock.lock();
    try {
      closed = true;
      changed.signal();
    } finally {
      lock.unlock();
    }
  }

  /** Nothing more comes, and what waits is dropped. */
  void abandon() {
    lock.lock();
    try {
      closed = true;
      waiting.clear();
      bytes = 0;
      changed.signal();
    } finally {
      lock.unlock();
    }
  }

  /** When the sink has last taken something, by the clock. */
  long takenNs() {
    lock.lock();
    try {
      return takenNs;
    } finally {
      lock.unlock();
    }
  }

  /** How many bytes wait now. */
  int waitingBytes() {
    lock.lock();
    try {
      return bytes;
    } finally {
      lock.unlock();
    }
  }

  /** Whether something waits now. */
  boolean waits() {
    lock.lock();
    try {
      return !waiting.isEmpty();
    } finally {
      lock.unlock();
    }
  }

  /** Whether nothing more comes. */
  boolean closed() {
    lock.lock();
    try {
      return closed;
    } finally {
      lock.unlock();
    }
  }
}
