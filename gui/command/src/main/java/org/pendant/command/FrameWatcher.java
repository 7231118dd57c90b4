package org.pendant.command;

import org.pendant.controller.state.ControllerState;

/** Frame watcher: looks at every frame of a run. */
interface FrameWatcher {

  /** Takes what a frame has brought. */
  void see(ControllerState state);

  /** Whether it needs no more frames; the program is then stopped. */
  boolean enough();
}
