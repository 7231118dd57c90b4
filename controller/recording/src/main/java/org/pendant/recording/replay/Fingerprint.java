package org.pendant.recording.replay;

import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

/**
 * Fingerprint of a run: a number that two runs share only as long as arm and program do the same,
 * bit for bit.
 */
final class Fingerprint {
  private static final long FACTOR = 0x9E3779B97F4A7C15L;

  private Fingerprint() {}

  /** That of {@code state}: joints, line and state of the program, digital signals. */
  static long of(ControllerState state) {
    ArmState arm = state.arm();
    long mixed = mix(state.frame(), state.program().line());
    mixed = mix(mixed, state.program().state().name().hashCode());
    mixed = mix(mixed, state.io().hashCode());
    mixed = mix(mixed, arm.targetPositionRad());
    mixed = mix(mixed, arm.actualPositionRad());
    return mix(mixed, arm.actualSpeedRadPerS());
  }

  private static long mix(long mixed, Joints joints) {
    long result = mixed;
    for (int i = 0; i < Joints.COUNT; i++) {
      result = mix(result, Double.doubleToRawLongBits(joints.get(i)));
    }
    return result;
  }

  private static long mix(long mixed, long more) {
    long result = (mixed ^ more) * FACTOR;
    return result ^ (result >>> 32);
  }
}
