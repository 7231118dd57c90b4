package org.pendant.recording;

import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControlMode;

/**
 * Control status: what the drives follow, and whether a motion is under way; see {@link ArmState}.
 */
record ControlStatus(ControlMode mode, boolean moving, boolean steady) {
  private static final ControlStatus[] ALL = new ControlStatus[4 * ControlMode.values().length];

  static {
    for (ControlMode mode : ControlMode.values()) {
      for (int i = 0; i < 4; i++) {
        ALL[4 * mode.code() + i] = new ControlStatus(mode, (i & 2) != 0, (i & 1) != 0);
      }
    }
  }

  /** One of few objects: nothing is allocated. */
  static ControlStatus of(ControlMode mode, boolean moving, boolean steady) {
    return ALL[4 * mode.code() + (moving ? 2 : 0) + (steady ? 1 : 0)];
  }

  static ControlStatus of(ArmState arm) {
    return of(arm.controlMode(), arm.moving(), arm.steady());
  }
}
