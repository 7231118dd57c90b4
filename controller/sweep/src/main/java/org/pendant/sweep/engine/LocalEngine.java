package org.pendant.sweep.engine;

import static org.pendant.sweep.engine.EngineTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.run.SweepResult;

/**
 * Local engine: threads of this process. Each takes the next variant when it has finished one, so a
 * long run holds up nobody but itself. Results wait for those of smaller numbers in a window of a
 * fixed size, so memory stays the same however many variants there are.
 */
public final class LocalEngine implements Engine {
  /** Results that may wait for an earlier one, for each worker. */
  private static final int WINDOW_PER_WORKER = 256;

  private static final long LOOK_NS = 50_000_000;

  private final Function<SweepVariant, SweepResult> runner;
  private final int workers;

  /**
   * An engine.
   *
   * @param workers how many runs there are at a time, 1 or more
   */
  public LocalEngine(SweepJob job, int workers) {
    this(job::run, workers);
  }

  /** As the other one, with another way to run a variant; it must throw nothing. */
  LocalEngine(Function<SweepVariant, SweepResult> runner, int workers) {
    this.runner = runner;
    this.workers = workers;
  }

  @Override
  public String description() {
    return workers == 1 ? text("oneWorker") : text("workers", workers);
  }

  @Override
  public long run(
      VariantSource variants, long first, long end, ResultSink sink, BooleanSupplier stopped)
      throws IOException {
    Window window = new Window(first, end, workers * WINDOW_PER_WORKER);
    for (int i = 0; i < workers; i++) {
      Thread.ofPlatform().daemon().name("sweep " + i).start(() -> work(variants, window));
    }
    try {
      while (!window.finished() && !stopped.getAsBoolean()) {
        for (SweepResult each : window.nextOnes()) {
          sink.take(each);
          window.taken();
        }
      }
      return window.next();
    } finally {
      window.close();
    }
  }

  private void work(VariantSource variants, Window window) {
    try {
      for (long number = window.claim(); number >= 0; number = window.claim()) {
        window.put(number, runner.apply(variants.variant(number)));
      }
    } catch (Throwable fault) {
      // nobody else would hear of it: the thread that waits for the result throws it
      window.fail(fault);
    }
  }

  @Override
  public void close() {
    // threads end with each run
  }

  /** The variants that are under way or wait for an earlier one. */
  private static final class Window {
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final SweepResult[] results;
    private final long end;
    private long claimed;
    private long next;
    private boolean closed;
    private Throwable fault;

    Window(long first, long end, int size) {
      this.end = end;
      results = new SweepResult[size];
      claimed = first;
      next = first;
    }

    /** The number of a variant to run, when there is room for its result; -1 for none any more. */
    long claim() throws InterruptedException {
      lock.lockInterruptibly();
      try {
        while (!closed && claimed < end && claimed >= next + results.length) {
          changed.await();
        }
        return closed || claimed >= end ? -1 : claimed++;
      } finally {
        lock.unlock();
      }
    }

    void put(long number, SweepResult result) {
      lock.lock();
      try {
        results[(int) (number % results.length)] = result;
        if (number == next) {
          changed.signalAll();
        }
      } finally {
        lock.unlock();
      }
    }

    /** The results that are next, in order; none when a moment has passed without. */
    List<SweepResult> nextOnes() {
      lock.lock();
      try {
        long leftNs = LOOK_NS;
        while (at(next) == null && fault == null && leftNs > 0) {
          leftNs = changed.awaitNanos(leftNs);
        }
        if (fault != null) {
          throw new IllegalStateException("a worker of the sweep has failed", fault);
        }
        List<SweepResult> found = new ArrayList<>();
        for (long i = next; i < end && found.size() < results.length && at(i) != null; i++) {
          found.add(at(i));
        }
        return found;
      } catch (InterruptedException e) {
        throw new IllegalStateException("nobody interrupts the thread that takes results", e);
      } finally {
        lock.unlock();
      }
    }

    private SweepResult at(long number) {
      return results[(int) (number % results.length)];
    }

    /** The next result has been taken. */
    void taken() {
      lock.lock();
      try {
        results[(int) (next % results.length)] = null;
        next++;
        changed.signalAll();
      } finally {
        lock.unlock();
      }
    }

    void fail(Throwable cause) {
      lock.lock();
      try {
        fault = cause;
        changed.signalAll();
      } finally {
        lock.unlock();
      }
    }

    boolean finished() {
      return next() >= end;
    }

    long next() {
      lock.lock();
      try {
        return next;
      } finally {
        lock.unlock();
      }
    }

    void close() {
      lock.lock();
      try {
        closed = true;
        changed.signalAll();
      } finally {
        lock.unlock();
      }
    }
  }
}
