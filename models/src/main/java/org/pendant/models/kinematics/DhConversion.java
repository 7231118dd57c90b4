package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrames;
import org.pendant.models.pose.Transforms;

/**
 * Conversion of whole links to Denavit-Hartenberg parameters: the common normals of consecutive
 * axes give the four numbers of each joint (B. Siciliano et al., "Robotics: Modelling, Planning and
 * Control", chapter 2.8.2).
 *
 * <p>Axes that are nearly parallel have their common normal far away, and lengths d of kilometres
 * that cancel. Kinematics are made from whole links; these numbers are for files and messages.
 */
public final class DhConversion {
  /**
   * Axes whose angle is smaller (rad) count as parallel: their normal would be so far away that
   * rounding moved the arm by more than the angle does.
   */
  private static final double PARALLEL_RAD = 1e-8;

  private static final int LAST = Joints.COUNT - 1;

  private final DhParameters nominal;
  private final double[] theta = new double[Joints.COUNT];
  private final double[] a = new double[Joints.COUNT];
  private final double[] d = new double[Joints.COUNT];
  private final double[] alpha = new double[Joints.COUNT];

  /** How far the link's frame is turned about its axis from that of the parameters, rad. */
  private double turnRad;

  /** How far it is along the axis, m. */
  private double alongM;

  private DhConversion(DhLengths dh) {
    nominal = dh.parameters();
  }

  /** Parameters of an arm, its calibration included. */
  public static DhParameters parameters(ArmDescription arm) {
    return switch (arm.calibration().geometry()) {
      case DhDeltas deltas -> deltas.on(arm.dh());
      case LinkFrames frames -> parameters(LinkTransforms.of(arm.dh(), frames), arm.dh());
    };
  }

  /** Parameters of six links as {@link LinkTransforms} has them; the last must keep the axis. */
  static DhParameters parameters(double[][] links, DhLengths dh) {
    DhConversion conversion = new DhConversion(dh);
    double[] link = new double[Transforms.SIZE];
    double[] before = new double[Transforms.SIZE];
    for (int i = 0; i < Joints.COUNT; i++) {
      LinkTransforms.slide(conversion.turnRad, conversion.alongM, before);
      Transforms.multiply(before, links[i], link);
      if (i < LAST && Math.hypot(link[2], link[5]) > PARALLEL_RAD) {
        conversion.addNormal(i, link);
      } else {
        conversion.addParallel(i, link);
      }
    }
    return new DhParameters(
        Joints.of(conversion.theta),
        Joints.of(conversion.a),
        Joints.of(conversion.d),
        Joints.of(conversion.alpha));
  }

  private void addNormal(int i, double[] link) {
    double length = Math.hypot(link[2], link[5]);
    double x = -link[5] / length;
    double y = link[2] / length;
    // so far alpha is above 0; a model without it leaves both ways along the normal
    double model = nominal.alphaRad().get(i);
    if (model < 0 || (model == 0 && x < 0)) {
      x = -x;
      y = -y;
    }
    double sine = y * link[2] - x * link[5];
    theta[i] = Math.atan2(y, x);
    alpha[i] = Math.atan2(sine, link[8]);
    a[i] = x * link[9] + y * link[10];
    alongM = (y * link[9] - x * link[10]) / sine;
    d[i] = link[11] - alongM * link[8];
    double ahead = x * link[0] + y * link[3];
    double aside = (x * link[3] - y * link[0]) * link[8] + link[6] * sine;
    turnRad = Math.atan2(aside, ahead);
  }

  /** Normals of parallel axes are everywhere; the one at the link's frame is taken. */
  private void addParallel(int i, double[] link) {
    double angle = Math.atan2(link[3], link[0]);
    double length = Math.hypot(link[9], link[10]);
    if (i == LAST) {
      theta[i] = angle;
    } else if (length > 0) {
      double sign = link[9] < 0 ? -1 : 1;
      a[i] = sign * length;
      theta[i] = Math.atan2(sign * link[10], sign * link[9]);
    }
    d[i] = link[11];
    turnRad = angle - theta[i];
    alongM = 0;
  }
}
