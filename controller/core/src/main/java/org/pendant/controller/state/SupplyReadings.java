package org.pendant.controller.state;

import org.pendant.controller.io.DigitalLevels;
import org.pendant.models.arm.Actuator;

/**
 * Currents that follow from a snapshot. Nothing electrical is simulated: these are figures of a
 * plausible size; docs/simulated-arm.md has them.
 */
public final class SupplyReadings {
  /** What each output that is high drives, A. */
  private static final double OUTPUT_A = 0.01;

  /** Share of a joint's largest torque by which its current may be off before the arm stops. */
  private static final double CURRENT_WINDOW = 0.35;

  private SupplyReadings() {}

  /** What the outputs of the control box drive, A. */
  public static double ioCurrentA(ControllerState state) {
    DigitalLevels io = state.io();
    return OUTPUT_A * (Integer.bitCount(io.standardOut()) + Integer.bitCount(io.configurableOut()));
  }

  /** How far the current of a joint may be from what its motion needs, A. */
  public static double currentWindowA(ControllerState state, int joint) {
    Actuator actuator = state.arm().description().actuators().get(joint);
    double maxTorqueNm = state.arm().description().joints().get(joint).maxTorqueNm();
    return CURRENT_WINDOW * maxTorqueNm / actuator.torqueConstantNmPerA();
  }
}
