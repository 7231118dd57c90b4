package org.pendant.desktop.shell;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.FrameListener;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/**
 * Rhythm of the window: how soon it shows the newest snapshot again. Often while something happens
 * or people do something, seldom while nothing does, and hardly ever while nobody sees it.
 */
final class RefreshRhythm implements FrameListener {
  static final int OFTEN_MS = 33;
  static final int SELDOM_MS = 250;
  static final int RESTING_MS = 1_000;
  static final int HIDDEN_MS = 1_000;

  /** So long nothing has happened when the rhythm slows down: what came of it is on the screen. */
  private static final long CALM_NS = TimeUnit.SECONDS.toNanos(1);

  /** So long nothing has happened when only the clock is left that people may look at. */
  private static final long RESTING_NS = TimeUnit.SECONDS.toNanos(5);

  /** An arm that rests is read elsewhere by noise alone, and nobody sees it, rad. */
  private static final double VISIBLE_RAD = 1e-3;

  private final LongSupplier nanoTime;
  private final Runnable hurry;
  private volatile long happenedNs;
  private volatile boolean slow;
  private boolean hidden;
  private ControllerState last;

  /**
   * A rhythm that begins fast.
   *
   * @param now the newest snapshot
   * @param hurry runs when something happens while the rhythm is slow; in the thread of the frames
   */
  RefreshRhythm(ControllerState now, Runnable hurry) {
    this(now, hurry, System::nanoTime);
  }

  RefreshRhythm(ControllerState now, Runnable hurry, LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
    this.hurry = hurry;
    last = now;
    happenedNs = nanoTime.getAsLong();
  }

  @Override
  public void frame(ControllerState state) {
    if (still(state) && looksLike(last, state)) {
      return;
    }
    last = state;
    happenedNs = nanoTime.getAsLong();
    if (slow) {
      slow = false;
      hurry.run();
    }
  }

  /** People have done something; whether the rhythm was not the fast one. Dispatch thread. */
  boolean touched() {
    happenedNs = nanoTime.getAsLong();
    boolean was = slow || hidden;
    slow = false;
    hidden = false;
    return was;
  }

  /**
   * When the window is to be refreshed again, ms from now. Dispatch thread.
   *
   * @param seen whether anybody can see it
   */
  int nextMs(boolean seen) {
    hidden = !seen;
    if (hidden) {
      // whatever happens: touched() tells when it is seen again
      slow = false;
      return HIDDEN_MS;
    }
    // first of all, so that nothing is overlooked that happens from here on
    slow = true;
    long calmNs = nanoTime.getAsLong() - happenedNs;
    if (calmNs > CALM_NS) {
      return calmNs > RESTING_NS ? RESTING_MS : SELDOM_MS;
    }
    slow = false;
    return OFTEN_MS;
  }

  private static boolean still(ControllerState state) {
    return state.debug().held()
        || (state.program().state() != ProgramState.RUNNING && state.arm().rests());
  }

  private static boolean looksLike(ControllerState a, ControllerState b) {
    return near(a.arm().actualPositionRad(), b.arm().actualPositionRad())
        && a.arm().targetPositionRad().equals(b.arm().targetPositionRad())
        && a.arm().tool().equals(b.arm().tool())
        && a.arm().speedFraction() == b.arm().speedFraction()
        && a.safety().equals(b.safety())
        && a.program().equals(b.program())
        && a.debug().equals(b.debug())
        && a.io().equals(b.io())
        && a.signals().equals(b.signals())
        && a.modbus().equals(b.modbus())
        && a.devices().equals(b.devices())
        && a.moved().equals(b.moved())
        && a.encoders().equals(b.encoders())
        && a.freedrive().equals(b.freedrive())
        && a.variables().equals(b.variables())
        && a.traced().equals(b.traced())
        && a.openPopups().equals(b.openPopups())
        && a.openQuestions().equals(b.openQuestions())
        && a.newestEntry() == b.newestEntry();
  }

  private static boolean near(Joints a, Joints b) {
    return a.maxAbsDifference(b) < VISIBLE_RAD;
  }
}
