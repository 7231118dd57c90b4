package org.pendant.models.kinematics;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrames;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

/**
 * Deviation of a calibrated arm from its model. Real arms are within a few millimetres and a
 * hundredth of a radian of it; a calibration that is further away is that of another model, or has
 * been spoilt.
 *
 * @param meanM mean distance of the flange from the model's over some postures, m
 * @param maxM the largest, m
 * @param frame name of the first link frame that is too far from its place in the frame before, or
 *     of the one that is furthest
 * @param frameM how far it is from there, m
 * @param frameRad how far it is turned there, rad
 */
public record NominalDeviation(
    double meanM, double maxM, String frame, double frameM, double frameRad) {
  /** A larger distance is no calibration, m; real ones are up to 5 mm. */
  public static final double MAX_M = 0.02;

  /** What a frame may be turned for each m that it may be moved, rad. */
  private static final double RAD_PER_M = 5;

  private static final String FLANGE = "flange";

  private static final List<Joints> POSTURES =
      List.of(
          Joints.ZERO,
          new Joints(0, -1.6, 0, -1.6, 0, 0),
          new Joints(0.1, -1.5, -1.6, -1.4, 1.5, 0.2),
          new Joints(1, -2, 1.2, 0.4, -1.2, 2),
          new Joints(-2, -0.7, 0.9, -2, 0.6, -1),
          new Joints(2.5, -1.1, 2.2, -2.8, -1.6, 0.7),
          new Joints(-0.8, -2.4, -1.1, 0.9, 2.4, -2.2),
          new Joints(3, -1.8, 1.9, 1.3, 0.3, 3));

  /** How far an arm is from its model. */
  public static NominalDeviation of(ArmDescription arm) {
    ForwardKinematics calibrated = new ForwardKinematics(arm);
    ForwardKinematics nominal = new ForwardKinematics(arm.dh());
    double sum = 0;
    double max = 0;
    for (Joints posture : POSTURES) {
      Pose reached = calibrated.flangePose(posture);
      double apartM = Poses.pointDistance(reached, nominal.flangePose(posture));
      sum += apartM;
      max = Math.max(max, apartM);
    }
    return furthest(arm, sum / POSTURES.size(), max);
  }

  /** Why an arm cannot be made so; empty if it can. */
  public static Optional<String> refusal(ArmDescription arm) {
    NominalDeviation found = of(arm);
    return found.maxM <= MAX_M
        ? Optional.empty()
        : Optional.of(
            KinematicsTexts.text(
                "offNominal",
                rounded(1, 1000 * found.maxM),
                rounded(1, 1000 * found.meanM),
                arm.displayName(),
                rounded(0, 1000 * MAX_M),
                found.frame,
                rounded(1, 1000 * found.frameM),
                rounded(2, Math.toDegrees(found.frameRad))));
  }

  private static String rounded(int decimals, double number) {
    return String.format(Locale.ROOT, "%." + decimals + "f", number);
  }

  private static NominalDeviation furthest(ArmDescription arm, double meanM, double maxM) {
    DhLengths dh = arm.dh();
    return switch (arm.calibration().geometry()) {
      case DhDeltas deltas ->
          furthest(
              LinkTransforms.of(dh, deltas), LinkTransforms.of(dh, DhDeltas.NONE), 1, meanM, maxM);
      case LinkFrames frames ->
          furthest(
              LinkTransforms.frames(frames),
              LinkTransforms.frames(LinkFrames.of(dh)),
              0,
              meanM,
              maxM);
    };
  }

  /**
   * @param first number of the frame that the first transformation leads to
   */
  private static NominalDeviation furthest(
      double[][] links, double[][] model, int first, double meanM, double maxM) {
    double[] back = new double[Transforms.SIZE];
    double[] apart = new double[Transforms.SIZE];
    NominalDeviation furthest = new NominalDeviation(meanM, maxM, FLANGE, 0, 0);
    double most = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      Transforms.invert(model[i], back);
      Transforms.multiply(back, links[i], apart);
      Pose pose = Transforms.toPose(apart);
      double shiftM = Poses.pointDistance(pose, Pose.ZERO);
      double turnRad = Poses.rotationAngle(pose, Pose.ZERO);
      double size = Math.max(shiftM, turnRad / RAD_PER_M);
      if (size > most && most <= MAX_M) {
        most = size;
        int number = first + i;
        String name = number < Joints.COUNT ? LinkFrames.NAMES.get(number) : FLANGE;
        furthest = new NominalDeviation(meanM, maxM, name, shiftM, turnRad);
      }
    }
    return furthest;
  }
}
