package org.pendant.command;

import java.util.OptionalDouble;
import org.pendant.command.service.PictureRenderer;
import org.pendant.controller.state.ControllerState;

/**
 * Exposure: keeps the frame that a picture is wanted of, and tells the renderer the path until
 * then.
 */
final class Exposure implements FrameWatcher {
  /** Frames are 2 ms apart; times are sums of that. */
  private static final double TOLERANCE_S = 1e-6;

  private final OptionalDouble atS;
  private final PictureRenderer renderer;
  private ControllerState kept;

  /**
   * @param first what there is before the first frame
   * @param atS robot time of the picture, s; without one the last frame is kept
   * @param renderer draws the trace of the tool centre point
   */
  Exposure(ControllerState first, OptionalDouble atS, PictureRenderer renderer) {
    this.atS = atS;
    this.renderer = renderer;
    kept = first;
    renderer.trace(first.arm(), first.timeS());
  }

  @Override
  public void see(ControllerState state) {
    if (atS.isEmpty() || state.timeS() <= atS.getAsDouble() + TOLERANCE_S) {
      kept = state;
      renderer.trace(state.arm(), state.timeS());
    }
  }

  @Override
  public boolean enough() {
    return atS.isPresent() && kept.timeS() >= atS.getAsDouble() - TOLERANCE_S;
  }

  /** Whether a picture was wanted of a time that was never reached. */
  boolean tooEarly() {
    return atS.isPresent() && !enough();
  }

  /** The frame of the picture. */
  ControllerState state() {
    return kept;
  }
}
