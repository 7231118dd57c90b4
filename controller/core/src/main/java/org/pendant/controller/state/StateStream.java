package org.pendant.controller.state;

import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * State stream: every snapshot of the controller in turn, for any number of readers. The frame loop
 * publishes without waiting; a reader that falls behind by more than {@link #KEPT} snapshots misses
 * the oldest ones.
 */
public final class StateStream {
  /** How many of the newest snapshots can still be taken: half a second of frames. */
  public static final int KEPT = 256;

  private record Numbered(long number, ControllerState state) {}

  private final AtomicReferenceArray<Numbered> ring = new AtomicReferenceArray<>(KEPT);
  private final CopyOnWriteArrayList<Subscription> followers = new CopyOnWriteArrayList<>();
  private volatile long newest;
  private volatile Runnable wake = () -> {};

  /** For the frame loop: a frame has ended. */
  public void publish(ControllerState state) {
    long number = newest + 1;
    ring.set((int) (number % KEPT), new Numbered(number, state));
    newest = number;
    for (Subscription follower : followers) {
      LockSupport.unpark(follower.waiting);
    }
  }

  /** Begins to follow, from the next snapshot on. One thread uses what this answers. */
  public Subscription follow() {
    return follow(() -> true);
  }

  /**
   * As {@link #follow()}.
   *
   * @param onTime whether each snapshot is needed as soon as its frame is due; while nobody needs
   *     that and nothing happens, several may come together. Asked by the frame loop: must be short
   */
  public Subscription follow(BooleanSupplier onTime) {
    Subscription follower = new Subscription(onTime);
    followers.add(follower);
    wake.run();
    return follower;
  }

  /** Whether anybody follows, by whatever rhythm: otherwise nothing need be published. */
  public boolean hasFollowers() {
    return !followers.isEmpty();
  }

  /** Whether somebody needs each snapshot as soon as its frame is due. */
  public boolean followed() {
    for (Subscription follower : followers) {
      if (follower.onTime.getAsBoolean()) {
        return true;
      }
    }
    return false;
  }

  /** Says that {@link #followed} may have changed. Any thread. */
  public void followedByMore() {
    wake.run();
  }

  /** Has {@code wake} run when {@link #followed} may have changed; it must be short. */
  public void wakeBy(Runnable wake) {
    this.wake = wake;
  }

  /**
   * Subscription of a reader that takes the snapshots in turn. Closing may be done by any thread.
   */
  public final class Subscription implements AutoCloseable {
    private long taken = newest;
    private long missed;
    private volatile Thread waiting;
    private volatile boolean closed;
    private final BooleanSupplier onTime;

    private Subscription(BooleanSupplier onTime) {
      this.onTime = onTime;
    }

    /**
     * Waits for the next snapshot. After {@link #close} it answers the newest one without waiting.
     *
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    public ControllerState take() throws InterruptedException {
      waiting = Thread.currentThread();
      while (taken == newest && !closed) {
        LockSupport.park(this);
        if (Thread.interrupted()) {
          throw new InterruptedException();
        }
      }
      return next();
    }

    private ControllerState next() {
      while (true) {
        long last = newest;
        long wanted = Math.min(last, Math.max(taken + 1, last - KEPT + 1));
        Numbered found = ring.get((int) (wanted % KEPT));
        // the frame loop may overtake between the two reads: then another one stands in this place
        if (found != null && found.number() == wanted) {
          missed += Math.max(0, wanted - taken - 1);
          taken = wanted;
          return found.state();
        }
      }
    }

    /** Whether {@link #close} was called. */
    public boolean closed() {
      return closed;
    }

    /** How many snapshots went by because this follower was too slow. */
    public long missed() {
      return missed;
    }

    /** Ends following; a thread that waits comes back. */
    @Override
    public void close() {
      closed = true;
      followers.remove(this);
      LockSupport.unpark(waiting);
    }
  }
}
