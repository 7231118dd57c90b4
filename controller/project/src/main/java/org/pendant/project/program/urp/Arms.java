package org.pendant.project.program.urp;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhParameters;
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

  /** Files round the lengths and angles of an arm without calibration, in m and rad. */
  private static final double ROUNDING = 1e-8;

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
  static Optional<String> model(ArmDescription described, ArmDescription expected) {
    ForwardKinematics arm = new ForwardKinematics(described);
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
    ForwardKinematics model = new ForwardKinematics(of);
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
   * The arm that is described in an element.
   *
   * @param like of which everything but the calibration is taken
   * @return empty if it describes none
   */
  static Optional<ArmDescription> described(XmlElement kinematics, ArmDescription like) {
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
    DhParameters nominal = like.dh().parameters();
    DhDeltas deltas =
        new DhDeltas(
            Joints.of(theta),
            apart(a, nominal.aM()),
            apart(d, nominal.dM()),
            apart(alpha, nominal.alphaRad()));
    return Optional.of(like.withCalibration(Calibration.of(deltas)));
  }

  private static Joints apart(double[] values, Joints nominal) {
    double[] apart = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      double difference = values[i] - nominal.get(i);
      apart[i] = Math.abs(difference) < ROUNDING ? 0 : difference;
    }
    return Joints.of(apart);
  }

  static double[] row(XmlElement kinematics, String name) {
    return Values.numbers(kinematics.child(name).map(each -> each.text("value")).orElse(""));
  }
}
