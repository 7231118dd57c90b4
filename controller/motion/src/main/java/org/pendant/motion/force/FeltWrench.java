package org.pendant.motion.force;

import java.util.Arrays;
import java.util.function.Supplier;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;
import org.pendant.models.time.FrameTime;

/**
 * Felt wrench: what pushes the tool at its TCP, and how fast that changes. The change is what tells
 * a hard surface from a soft one: there the force grows with the speed.
 */
final class FeltWrench {
  /** How soon a change of the force's rate is believed, s. */
  private static final double FILTER_S = 0.004;

  private static final double SHARE = FrameTime.FRAME_S / (FILTER_S + FrameTime.FRAME_S);
  private static final int N = 6;

  private final MeasuredArm arm;
  private final Supplier<Wrench> atFlangeInBase;
  private final double[] flange12 = new double[Transforms.SIZE];
  private final double[] now = new double[N];
  private final double[] before = new double[N];
  private final double[] rate = new double[N];
  private boolean hasBefore;

  /**
   * A wrench that has not been felt yet.
   *
   * @param atFlangeInBase on the tool, at the flange's origin along the axes of the base
   */
  FeltWrench(MeasuredArm arm, Supplier<Wrench> atFlangeInBase) {
    this.arm = arm;
    this.atFlangeInBase = atFlangeInBase;
  }

  /** What was felt before does not compare with what will be. */
  void forget() {
    hasBefore = false;
    Arrays.fill(rate, 0);
  }

  /** Feels what acts in this frame, about the TCP. */
  void feel(Pose tcpInFlange) {
    Wrench w = atFlangeInBase.get();
    arm.copyFlangeInBase(flange12);
    double x = turned(0, tcpInFlange);
    double y = turned(1, tcpInFlange);
    double z = turned(2, tcpInFlange);
    now[0] = w.fx();
    now[1] = w.fy();
    now[2] = w.fz();
    now[3] = w.mx() - (y * w.fz() - z * w.fy());
    now[4] = w.my() - (z * w.fx() - x * w.fz());
    now[5] = w.mz() - (x * w.fy() - y * w.fx());
    for (int i = 0; i < N; i++) {
      if (hasBefore) {
        double change = (now[i] - before[i]) / FrameTime.FRAME_S;
        rate[i] += SHARE * (change - rate[i]);
      }
      before[i] = now[i];
    }
    hasBefore = true;
  }

  private double turned(int row, Pose offset) {
    return flange12[3 * row] * offset.x()
        + flange12[3 * row + 1] * offset.y()
        + flange12[3 * row + 2] * offset.z();
  }

  /** Force, N, and torque about the TCP, Nm, along the axes of the base. */
  double[] wrench() {
    return now;
  }

  /** How fast they change, N/s and Nm/s, as a mean of the last frames. */
  double[] rate() {
    return rate;
  }
}
