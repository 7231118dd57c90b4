package org.pendant.command;

import org.pendant.controller.state.ControllerState;

/** Frame watcher: looks at every frame of a run. */
interface FrameWatcher {

  /** Whether it is shown the frames; a snapshot of each costs time. */
  default boolean looks() {
    return true;
  }

  /** Takes what a frame has brought, if it {@link #looks}. */
  void see(ControllerState state);

  /** Whether it needs no more frames; the program is then stopped. */
  boolean enough();
}
