package org.pendant.recording;

import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControlMode;

/** What the drives follow, and whether a motion is under way; see {@link ArmState}. */
record Control(ControlMode mode, boolean moving, boolean steady) {
  private static final Control[] ALL = new Control[4 * ControlMode.values().length];

  static {
    for (ControlMode mode : ControlMode.values()) {
      for (int i = 0; i < 4; i++) {
        ALL[4 * mode.code() + i] = new Control(mode, (i & 2) != 0, (i & 1) != 0);
      }
    }
  }

  /** One of few objects: nothing is allocated. */
  static Control of(ControlMode mode, boolean moving, boolean steady) {
    return ALL[4 * mode.code() + (moving ? 2 : 0) + (steady ? 1 : 0)];
  }

  static Control of(ArmState arm) {
    return of(arm.controlMode(), arm.moving(), arm.steady());
  }
}
