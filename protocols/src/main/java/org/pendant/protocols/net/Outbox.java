package org.pendant.protocols.net;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** What waits to be sent to one peer, with a bound on its bytes. */
final class Outbox {
  /** Most bytes that wait. */
  static final int CAPACITY = 1 << 20;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Queue<byte[]> waiting = new ArrayDeque<>();
  private int bytes;
  private boolean closed;

  /** Puts a message at the end; answers whether there was room. */
  boolean offer(byte[] message) {
    lock.lock();
    try {
      if (closed || bytes + message.length > CAPACITY) {
        return false;
      }
      bytes += message.length;
      waiting.add(message);
      changed.signal();
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Waits for the next message; null when the outbox is closed and empty. */
  byte[] take() throws InterruptedException {
    lock.lock();
    try {
      while (waiting.isEmpty() && !closed) {
        changed.await();
      }
      byte[] message = waiting.poll();
      if (message != null) {
        bytes -= message.length;
      }
      return message;
    } finally {
      lock.unlock();
    }
  }

  /** Nothing more comes; what waits may still be taken. */
  void close() {
    lock.lock();
    try {
      closed = true;
      changed.signal();
    } finally {
      lock.unlock();
    }
  }
}
