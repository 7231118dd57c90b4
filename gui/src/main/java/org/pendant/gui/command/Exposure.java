package org.pendant.gui.command;

import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.scene.Trace;
import org.pendant.gui.scene.TraceRing;

/** Keeps the frame that a picture is wanted of, and the way of the tool until then. */
final class Exposure implements FrameWatcher {
  /** Half a minute of steady motion at millimetres a frame. */
  private static final int MAX_POINTS = 20_000;

  /** Frames are 2 ms apart; times are sums of that. */
  private static final double TOLERANCE_S = 1e-6;

  private final Optional<Double> atS;
  private final TraceRing ring = new TraceRing(MAX_POINTS);
  private ControllerState kept;

  /**
   * @param first what there is before the first frame
   * @param atS robot time of the picture, s; without one the last frame is kept
   */
  Exposure(ControllerState first, Optional<Double> atS) {
    this.atS = atS;
    kept = first;
    ring.add(first.arm(), first.timeS());
  }

  @Override
  public void see(ControllerState state) {
    if (atS.isEmpty() || state.timeS() <= atS.get() + TOLERANCE_S) {
      kept = state;
      ring.add(state.arm(), state.timeS());
    }
  }

  @Override
  public boolean enough() {
    return atS.isPresent() && kept.timeS() >= atS.get() - TOLERANCE_S;
  }

  /** Whether a picture was wanted of a time that was never reached. */
  boolean tooEarly() {
    return atS.isPresent() && !enough();
  }

  /** The frame of the picture. */
  ControllerState state() {
    return kept;
  }

  /** Where the tool centre point has been until then. */
  Trace trace() {
    return ring.trace();
  }
}
