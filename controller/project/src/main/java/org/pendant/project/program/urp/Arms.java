package org.pendant.project.program.urp;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Arm of a program: the one that it was made on, of which files keep the calibrated lengths and
 * angles.
 */
final class Arms {
  private static final String USUAL = "ur5e";
  private static final double QUARTER = Math.PI / 2;

  /** Files round the angles of an arm without calibration. */
  private static final double ROUNDING_RAD = 1e-8;

  /** How far the flange of a calibrated arm is at most from that of its model, m. */
  private static final double MAX_M = 0.01;

  /** How near it is without calibration, m; files round the lengths. */
  private static final double SAME_M = 1e-4;

  /** Positions in which no two models have their flanges at one place. */
  private static final List<Joints> PROBES =
      List.of(
          Joints.ZERO,
          new Joints(0.1, -1.5, -1.6, -1.4, 1.5, 0.2),
          new Joints(1, -2, 1.2, 0.4, -1.2, 2),
          new Joints(-2, -0.7, 0.9, -2, 0.6, -1));

  private Arms() {}

  /**
   * The id of the model that an arm is of; empty if it is like none of them.
   *
   * @param expected counts where several models have the same lengths
   */
  static Optional<String> model(ForwardKinematics arm, ArmDescription expected) {
    double leastM = apartM(arm, expected);
    if (leastM < SAME_M) {
      return Optional.of(expected.id());
    }
    Optional<String> nearest = leastM < MAX_M ? Optional.of(expected.id()) : Optional.empty();
    for (String id : ArmLibrary.ids()) {
      double apartM = apartM(arm, ArmLibrary.load(id));
      if (apartM < Math.min(leastM, MAX_M)) {
        nearest = Optional.of(id);
        leastM = apartM;
      }
    }
    return nearest;
  }

  private static double apartM(ForwardKinematics arm, ArmDescription of) {
    ForwardKinematics model = new ForwardKinematics(of.dh());
    return PROBES.stream()
        .mapToDouble(
            joints ->
                Poses.distance(model.tcpPose(joints, Pose.ZERO), arm.tcpPose(joints, Pose.ZERO)))
        .max()
        .orElseThrow();
  }

  /** The arm of an id; a common one if there is none. */
  static ArmDescription of(String id) {
    return ArmLibrary.load(ArmLibrary.find(id).orElse(USUAL));
  }

  /**
   * Forward kinematics of the arm that is described in an element.
   *
   * @return empty if it describes none
   */
  static Optional<ForwardKinematics> described(XmlElement kinematics) {
    double[] theta = row(kinematics, "deltaTheta");
    double[] a = row(kinematics, "a");
    double[] d = row(kinematics, "d");
    double[] alpha = row(kinematics, "alpha");
    boolean whole =
        theta.length == Joints.COUNT
            && a.length == Joints.COUNT
            && d.length == Joints.COUNT
            && alpha.length == Joints.COUNT;
    if (!whole || a[1] == 0 || a[2] == 0) {
      return Optional.empty();
    }
    Joints alphas =
        new Joints(
            apart(alpha[0], QUARTER),
            apart(alpha[1], 0),
            apart(alpha[2], 0),
            apart(alpha[3], QUARTER),
            apart(alpha[4], -QUARTER),
            apart(alpha[5], 0));
    DhDeltas deltas =
        new DhDeltas(
            Joints.of(theta),
            new Joints(a[0], 0, 0, a[3], a[4], a[5]),
            new Joints(0, d[1], d[2], 0, 0, 0),
            alphas);
    return Optional.of(
        new ForwardKinematics(new DhLengths(d[0], a[1], a[2], d[3], d[4], d[5]), deltas));
  }

  private static double apart(double value, double nominal) {
    double difference = value - nominal;
    return Math.abs(difference) < ROUNDING_RAD ? 0 : difference;
  }

  private static double[] row(XmlElement kinematics, String name) {
    return Values.numbers(kinematics.child(name).map(each -> each.text("value")).orElse(""));
  }
}
