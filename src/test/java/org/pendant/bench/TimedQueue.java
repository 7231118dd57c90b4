package org.pendant.bench;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.lang.management.ManagementFactory;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;

/** The event queue, with a clock. */
final class TimedQueue extends EventQueue {
  /** When the first key or turn of the wheel since {@link #begin} was dispatched. */
  final AtomicLong begunNs = new AtomicLong();

  /** What the dispatch thread had computed then. */
  final AtomicLong begunCpuNs = new AtomicLong();

  /** What it has computed at {@link #awaitPainted}. */
  final AtomicLong endCpuNs = new AtomicLong();

  /** The longest event of any kind. */
  final AtomicLong longestNs = new AtomicLong();

  /** What the present thread has computed so far. */
  static long cpuNs() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  void begin() {
    begunNs.set(0);
  }

  /** Waits until what has been posted is painted; from the first of it to then, ns. */
  long awaitPainted() throws InterruptedException {
    CountDownLatch done = new CountDownLatch(1);
    AtomicLong end = new AtomicLong();
    // Twice: repainting is asked for by the event, and is in the queue before the second.
    EventQueue.invokeLater(
        () ->
            EventQueue.invokeLater(
                () -> {
                  end.set(System.nanoTime());
                  endCpuNs.set(cpuNs());
                  done.countDown();
                }));
    done.await();
    return end.get() - begunNs.get();
  }

  @Override
  protected void dispatchEvent(AWTEvent event) {
    long start = System.nanoTime();
    if (event.getID() == KeyEvent.KEY_PRESSED || event.getID() == MouseEvent.MOUSE_WHEEL) {
      begunNs.compareAndSet(0, start);
      begunCpuNs.set(cpuNs());
    }
    super.dispatchEvent(event);
    longestNs.accumulateAndGet(System.nanoTime() - start, Math::max);
  }
}
