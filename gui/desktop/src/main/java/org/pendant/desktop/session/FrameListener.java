package org.pendant.desktop.session;

import org.pendant.controller.state.ControllerState;

/**
 * Frame listener: sees every frame. It is called in the thread that drives the controller and must
 * be short.
 */
@FunctionalInterface
public interface FrameListener {

  /** A frame has ended. */
  void frame(ControllerState state);
}
