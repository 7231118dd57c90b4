package org.pendant.models.kinematics;

import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Pose residuals: how far measured poses are from those that an arm would have.
 *
 * @param meanM mean distance, m
 * @param maxM the largest, m
 * @param meanRad mean angle, rad
 * @param maxRad the largest, rad
 */
public record PoseResiduals(double meanM, double maxM, double meanRad, double maxRad) {
  /** The residuals of an arm, its calibration included. */
  public static PoseResiduals of(ArmDescription arm, List<MeasuredPose> measured) {
    ForwardKinematics forward = new ForwardKinematics(arm);
    double sumM = 0;
    double maxM = 0;
    double sumRad = 0;
    double maxRad = 0;
    for (MeasuredPose each : measured) {
      Pose reached = forward.flangePose(each.positionRad());
      double apartM = Poses.pointDistance(reached, each.flangeInBase());
      double apartRad = Poses.rotationAngle(reached, each.flangeInBase());
      sumM += apartM;
      maxM = Math.max(maxM, apartM);
      sumRad += apartRad;
      maxRad = Math.max(maxRad, apartRad);
    }
    return new PoseResiduals(sumM / measured.size(), maxM, sumRad / measured.size(), maxRad);
  }
}
