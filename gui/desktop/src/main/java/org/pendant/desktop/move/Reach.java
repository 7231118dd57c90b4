package org.pendant.desktop.move;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.InverseResult;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Pose;

/**
 * Reach: whether the arm reaches a pose.
 *
 * @param q joint positions in rad that do, the nearest ones; empty if none do
 * @param text why none do, or that the pose is close to a singularity; empty if there is nothing to
 *     say
 */
public record Reach(Optional<Joints> q, String text) {
  /** Nearer than this to a singularity, straight moves become slow or impossible. */
  private static final double CLOSE = 0.03;

  /** A finer error than a user types. */
  private static final double ERROR = 1e-9;

  /** Looks for joint positions near {@code near} that put the TCP at {@code tcpInBase}. */
  public static Reach of(
      ArmDescription arm,
      InverseKinematics inverse,
      Pose tcpInBase,
      Pose tcpInFlange,
      Joints near) {
    Pose flange = InverseKinematics.flangeOf(tcpInBase, tcpInFlange);
    return switch (inverse.find(flange, near, ERROR, ERROR)) {
      case InverseResult.Reached found ->
          new Reach(Optional.of(found.q()), singularity(arm, found.q()));
      case InverseResult.Unreachable none ->
          new Reach(
              Optional.empty(), MoveTexts.text("theArmCannotReachThisPose", none.cause().text()));
    };
  }

  private static String singularity(ArmDescription arm, Joints q) {
    for (Singularity each : Singularity.values()) {
      if (each.measure(arm.dh(), q) < CLOSE) {
        return switch (each) {
          case SHOULDER -> MoveTexts.text("closeToShoulderSingularity");
          case ELBOW -> MoveTexts.text("closeToElbowSingularity");
          case WRIST -> MoveTexts.text("closeToWristSingularity");
        };
      }
    }
    return "";
  }
}
