package org.pendant.controller.arm;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Temperatures of the joints and of the electronics in the tool flange: each comes nearer to what
 * its losses lead to, with the share {@code dt / time constant} of the difference a frame.
 */
final class JointHeat {
  /** Temperature of the room, degrees Celsius. */
  static final double AMBIENT_C = 25;

  /** How much the electronics of a powered joint warm it, K: the small joints most. */
  private static final double[] POWERED_RISE_K = {5.6, 6.3, 6.0, 10.0, 12.8, 13.8};

  /** How much a motor at its largest torque would warm its joint, K; with the torque squared. */
  private static final double FULL_TORQUE_RISE_K = 60;

  private static final double TOOL_RISE_K = 5;
  private static final double TIME_CONSTANT_S = 1200;
  private static final double SHARE = FrameTime.FRAME_S / TIME_CONSTANT_S;
  private static final int N = Joints.COUNT;

  private final double[] maxTorqueNm = new double[N];
  private final double[] leadsToC = new double[N];
  private double toolLeadsToC;

  /**
   * Joints of an arm that carries nothing yet.
   *
   * @param warm whether it has been powered for hours; otherwise it is as cold as the room
   */
  JointHeat(ArmDescription arm, SimulatedSensors sensors, boolean warm) {
    for (int i = 0; i < N; i++) {
      maxTorqueNm[i] = arm.joints().get(i).maxTorqueNm();
    }
    load(sensors, warm);
    System.arraycopy(leadsToC, 0, sensors.temperatureC, 0, N);
    sensors.toolTemperatureC = toolLeadsToC;
    load(sensors, false);
  }

  /** Takes the torques that the motors give now. */
  void load(SimulatedSensors sensors, boolean powered) {
    for (int i = 0; i < N; i++) {
      double share = sensors.torqueNm[i] / maxTorqueNm[i];
      leadsToC[i] =
          AMBIENT_C + (powered ? POWERED_RISE_K[i] : 0) + FULL_TORQUE_RISE_K * share * share;
    }
    toolLeadsToC = AMBIENT_C + (powered ? TOOL_RISE_K : 0);
  }

  /** Warms or cools for a frame. */
  void step(SimulatedSensors sensors) {
    double[] temperature = sensors.temperatureC;
    for (int i = 0; i < N; i++) {
      temperature[i] += SHARE * (leadsToC[i] - temperature[i]);
    }
    sensors.toolTemperatureC += SHARE * (toolLeadsToC - sensors.toolTemperatureC);
  }
}
