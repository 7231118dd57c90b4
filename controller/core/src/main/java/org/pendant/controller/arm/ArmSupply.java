package org.pendant.controller.arm;

import java.util.List;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Supply of the arm: what it takes from its 48 V supply: the electronics of a powered arm, the work
 * of its motors and what they lose as heat. An arm that gives back more than it takes heats a
 * resistor. docs/simulated-arm.md has the figures, which are of a plausible size.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class ArmSupply {
  /** Voltage of the supply, V. */
  public static final double VOLTAGE_V = 48;

  /** What joints and tool of a powered arm take without moving, W. */
  static final double ELECTRONICS_W = 24;

  /** Resistance of the windings, seen at the joint, ohm. */
  static final double WINDINGS_OHM = 0.6;

  private final double[] amperePerNm = new double[Joints.COUNT];
  private double powerW;
  private double consumedJ;
  private double dissipatedJ;

  /** The supply of an arm that has taken nothing yet. */
  public ArmSupply(ArmDescription arm) {
    List<Actuator> actuators = arm.actuators();
    for (int i = 0; i < Joints.COUNT; i++) {
      amperePerNm[i] = 1 / actuators.get(i).torqueConstantNmPerA();
    }
  }

  /** Takes in what the motors did in a frame. */
  public void step(SimulatedSensors sensors, boolean powered) {
    powerW = powered ? ELECTRONICS_W + motorsW(sensors) : 0;
    if (powerW > 0) {
      consumedJ += powerW * FrameTime.FRAME_S;
    } else {
      dissipatedJ -= powerW * FrameTime.FRAME_S;
    }
  }

  private double motorsW(SimulatedSensors sensors) {
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double currentA = sensors.torqueNm[i] * amperePerNm[i];
      sum += sensors.torqueNm[i] * sensors.speedRadPerS[i] + WINDINGS_OHM * currentA * currentA;
    }
    return sum;
  }

  /** The current that the arm takes, A; 0 while it gives back. */
  public double currentA() {
    return Math.max(0, powerW) / VOLTAGE_V;
  }

  /** Energy taken since the controller was switched on, J. */
  public double consumedJ() {
    return consumedJ;
  }

  /** Energy given back in braking and turned into heat since then, J. */
  public double dissipatedJ() {
    return dissipatedJ;
  }
}
