package org.pendant.controller.arm;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.Series;

/**
 * Supply meter: what the box reads of the voltages and the current of its arm. Exact readings are
 * those of an ideal 48 V supply. Measured ones have the level of recorded boxes, offsets of this
 * box and its joints, noise and steps; docs/simulated-arm.md has the figures.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class SupplyMeter {
  /** What the wires to the arm, and those to a joint, take from the voltage, ohm. */
  private static final double WIRES_OHM = 0.05;

  private static final double E_SERIES_V = 47.75;
  private static final double CB3_V = 48.2;

  /** How far a box may be from the others, and the voltage of its arm from its own, V. */
  private static final double BOX_V = 0.07;

  /** How far the joints are below the arm on average, V. */
  private static final double JOINTS_BELOW_V = 0.2;

  /** How far a joint may be from the others, V. */
  private static final double JOINT_V = 0.1;

  private static final double NOISE_V = 0.018;
  private static final double NOISE_A = 0.045;

  /** Voltages of box and arm are read with 16 bits, V. */
  private static final double STEP_V = 58.7 / (1 << 16);

  /** Voltages of joints are read with 12 bits, V. */
  private static final double JOINT_STEP_V = 58.7 / (1 << 12);

  private static final double STEP_A = 0.00224;
  private static final int N = Joints.COUNT;

  private final ArmSupply supply;
  private final boolean exact;
  private final GaussianNoise gaussian;
  private final double boxV;
  private final double robotOffsetV;
  private final double[] jointOffsetV = new double[N];
  private final double[] jointNoiseV = new double[N];
  private double boxNoiseV;
  private double robotNoiseV;
  private double noiseA;

  /**
   * A meter at a supply.
   *
   * @param noise whether readings are exact
   * @param seed of offsets and noise
   */
  public SupplyMeter(ArmDescription arm, ArmSupply supply, ReadingNoise noise, long seed) {
    this.supply = supply;
    exact = !noise.measured();
    gaussian = new GaussianNoise(Long.reverse(seed) + 1);
    double nominalV = arm.series() == Series.CB3 ? CB3_V : E_SERIES_V;
    boxV = exact ? ArmSupply.VOLTAGE_V : nominalV + BOX_V * gaussian.uniform();
    robotOffsetV = exact ? 0 : BOX_V * gaussian.uniform();
    for (int i = 0; i < N && !exact; i++) {
      jointOffsetV[i] = JOINT_V * gaussian.uniform() - JOINTS_BELOW_V;
    }
  }

  /** Reads; once a frame. */
  public void step() {
    if (exact) {
      return;
    }
    boxNoiseV = NOISE_V * gaussian.next();
    robotNoiseV = NOISE_V * gaussian.next();
    noiseA = NOISE_A * gaussian.next();
    for (int i = 0; i < N; i++) {
      jointNoiseV[i] = NOISE_V * gaussian.next();
    }
  }

  /** Voltage of the control box's supply, V. */
  public double boxV() {
    return read(boxV + boxNoiseV, STEP_V);
  }

  /** Voltage at an arm that has power, V. */
  public double robotV() {
    return read(atRobotV() + robotNoiseV, STEP_V);
  }

  private double atRobotV() {
    return boxV + robotOffsetV - WIRES_OHM * supply.currentA();
  }

  /**
   * Voltage at a joint of an arm that has power, V.
   *
   * @param currentA of its motor
   */
  public double jointV(int joint, double currentA) {
    return read(
        atRobotV() + jointOffsetV[joint] - WIRES_OHM * Math.abs(currentA) + jointNoiseV[joint],
        JOINT_STEP_V);
  }

  /** The current that the arm takes, A; 0 while it gives back. */
  public double currentA() {
    double trueA = supply.currentA();
    return trueA == 0 ? 0 : Math.max(0, read(trueA + noiseA, STEP_A));
  }

  private double read(double value, double step) {
    return exact ? value : GaussianNoise.quantized(value, step);
  }
}
