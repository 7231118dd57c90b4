package org.pendant.controller.state;

import org.pendant.controller.arm.ArmSupply;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.models.arm.Actuator;

/**
 * Voltages and currents of the control box. Nothing electrical is simulated: these are figures of a
 * plausible size that follow from what the arm does; docs/simulated-arm.md has them.
 */
public final class SupplyReadings {
  /** What the wires to the arm take from the voltage, ohm. */
  private static final double WIRES_OHM = 0.05;

  /** What each output that is high drives, A. */
  private static final double OUTPUT_A = 0.01;

  /** Share of a joint's largest torque by which its current may be off before the arm stops. */
  private static final double CURRENT_WINDOW = 0.35;

  private SupplyReadings() {}

  /** Voltage of the control box's supply, V. */
  public static double mainV(ControllerState state) {
    return ArmSupply.VOLTAGE_V;
  }

  /** Voltage at the arm, V; 0 without power. */
  public static double robotV(ControllerState state) {
    return RobotBits.powerOn(state)
        ? ArmSupply.VOLTAGE_V - WIRES_OHM * state.readings().robotCurrentA()
        : 0;
  }

  /** Voltage at each joint, V; that at the arm less what a motor of this current takes. */
  public static double jointV(ControllerState state, int joint) {
    return RobotBits.powerOn(state)
        ? robotV(state) - WIRES_OHM * Math.abs(state.readings().currentA().get(joint))
        : 0;
  }

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
