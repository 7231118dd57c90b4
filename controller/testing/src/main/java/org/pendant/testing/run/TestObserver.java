package org.pendant.testing.run;

import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;

/** Test observer: sees every frame of a test, to record it for instance. */
public interface TestObserver {
  /** Sees nothing. */
  TestObserver NONE =
      new TestObserver() {
        @Override
        public void begins(Drive drive) {}

        @Override
        public void sees(ControllerState state) {}
      };

  /** The controller of the test has been switched on; no frame has gone by. */
  void begins(Drive drive);

  /** A frame has gone by. */
  void sees(ControllerState state);
}
