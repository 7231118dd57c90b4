package org.pendant.desktop.shell;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.function.BooleanSupplier;
import javax.swing.Timer;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.fault.Faults;

/** Refresh timer: has the window refreshed in its {@link RefreshRhythm}. */
final class RefreshTimer {
  /** What people do, and what happens to windows. */
  private static final long TOUCHES =
      AWTEvent.MOUSE_EVENT_MASK
          | AWTEvent.MOUSE_MOTION_EVENT_MASK
          | AWTEvent.MOUSE_WHEEL_EVENT_MASK
          | AWTEvent.KEY_EVENT_MASK
          | AWTEvent.WINDOW_EVENT_MASK
          | AWTEvent.WINDOW_STATE_EVENT_MASK
          | AWTEvent.WINDOW_FOCUS_EVENT_MASK;

  private final RobotSession session;
  private final Runnable refresh;
  private final BooleanSupplier seen;
  private final RefreshRhythm rhythm;
  private final Timer timer = Faults.timer(RefreshRhythm.OFTEN_MS, this::turn);
  private final AWTEventListener touch = event -> touched();

  /**
   * Not started yet.
   *
   * @param refresh shows the newest snapshot
   * @param seen whether people can see any of it
   */
  RefreshTimer(RobotSession session, Runnable refresh, BooleanSupplier seen) {
    this.session = session;
    this.refresh = refresh;
    this.seen = seen;
    rhythm = new RefreshRhythm(session.state(), () -> EventQueue.invokeLater(this::now));
  }

  void start() {
    timer.start();
    session.addFrameListener(rhythm);
    Toolkit.getDefaultToolkit().addAWTEventListener(touch, TOUCHES);
  }

  void stop() {
    timer.stop();
    session.removeFrameListener(rhythm);
    Toolkit.getDefaultToolkit().removeAWTEventListener(touch);
  }

  private void touched() {
    if (rhythm.touched()) {
      // after what the event itself does
      EventQueue.invokeLater(this::now);
    }
  }

  private void now() {
    if (timer.isRunning()) {
      turn();
    }
  }

  private void turn() {
    Faults.guard(refresh);
    int nextMs = rhythm.nextMs(seen.getAsBoolean());
    if (nextMs != timer.getDelay()) {
      timer.setInitialDelay(nextMs);
      timer.setDelay(nextMs);
      timer.restart();
    }
  }
}
