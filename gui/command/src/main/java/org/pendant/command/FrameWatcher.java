package org.pendant.command;

import org.pendant.controller.state.ControllerState;

/** Looks at every frame of a run. */
interface FrameWatcher {

  /** Takes what a frame has brought. */
  void see(ControllerState state);

  /** Whether it needs no more frames; the program is then stopped. */
  boolean enough();
}
