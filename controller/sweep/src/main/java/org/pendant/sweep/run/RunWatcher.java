package org.pendant.sweep.run;

import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;

/** Run watcher: somebody who sees every frame of a run, such as a recording. */
public interface RunWatcher {
  /** Nobody. */
  RunWatcher NONE =
      new RunWatcher() {
        @Override
        public void begin(Drive drive) {
          // nobody
        }

        @Override
        public void see(ControllerState state) {
          // nobody
        }
      };

  /** The controller is switched on, and no frame has gone by. */
  void begin(Drive drive);

  /** A frame has ended. */
  void see(ControllerState state);
}
