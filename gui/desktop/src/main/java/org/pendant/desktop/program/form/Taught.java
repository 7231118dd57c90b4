package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.move.Reach;
import org.pendant.kit.form.Measure;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.WaypointPosition;

/** Taught positions of waypoints: as the arm stands, typed, and whether the arm gets there. */
public final class Taught {
  /** Nearer than this to the end of a joint's range something should be said. */
  private static final double NEAR_RAD = Math.toRadians(5);

  private static final List<String> JOINTS =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

  private Taught() {}

  /** The name of a joint, 0 to 5. */
  static String joint(int index) {
    return JOINTS.get(index);
  }

  /**
   * Where the arm is now.
   *
   * @param feature in which it is written down; the base stands in for the tool, which moves along,
   *     and for a feature that is missing or not taught
   */
  public static WaypointPosition here(
      ControllerState state, Installation installation, String feature) {
    String frame = frame(installation, feature).isPresent() ? feature : WaypointPosition.BASE;
    return new WaypointPosition(
        inFrame(state.arm().actualTcpInBase(), frame(installation, frame).orElse(Pose.ZERO)),
        frame,
        state.arm().actualPositionRad(),
        state.arm().tool().inFlange());
  }

  /** The pose of a feature in the base; empty if it is none, or moves. */
  static Optional<Pose> frame(Installation installation, String feature) {
    return feature.equals(WaypointPosition.BASE)
        ? Optional.of(Pose.ZERO)
        : installation.feature(feature).flatMap(FeaturePoses::pose);
  }

  private static Pose inFrame(Pose inBase, Pose frame) {
    return frame.equals(Pose.ZERO) ? inBase : Poses.trans(Poses.inverse(frame), inBase);
  }

  private static Pose inBase(WaypointPosition position, Installation installation) {
    Pose frame = frame(installation, position.feature()).orElse(Pose.ZERO);
    return frame.equals(Pose.ZERO) ? position.tcp() : Poses.trans(frame, position.tcp());
  }

  /** The position with other joint positions, and the pose that comes of them. */
  static WaypointPosition withJoints(
      WaypointPosition was, Joints jointsRad, ArmDescription arm, Installation installation) {
    Pose tcp = new ForwardKinematics(arm).tcpPose(jointsRad, was.toolInFlange());
    Pose frame = frame(installation, was.feature()).orElse(Pose.ZERO);
    return new WaypointPosition(inFrame(tcp, frame), was.feature(), jointsRad, was.toolInFlange());
  }

  /** The position with another pose, and the nearest joint positions if the arm gets there. */
  static WaypointPosition withTcp(
      WaypointPosition was, Pose tcp, ArmDescription arm, Installation installation) {
    WaypointPosition moved =
        new WaypointPosition(tcp, was.feature(), was.jointsRad(), was.toolInFlange());
    Joints joints = reach(moved, arm, installation).q().orElse(was.jointsRad());
    return new WaypointPosition(tcp, was.feature(), joints, was.toolInFlange());
  }

  private static Reach reach(
      WaypointPosition position, ArmDescription arm, Installation installation) {
    return Reach.of(
        arm,
        new InverseKinematics(arm),
        inBase(position, installation),
        position.toolInFlange(),
        position.jointsRad());
  }

  /**
   * What is to be said of a position: that the arm does not get there, or hardly.
   *
   * @param angle how people read angles
   */
  static String remark(
      WaypointPosition position, ArmDescription arm, Installation installation, Measure angle) {
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limits = arm.joints().get(i);
      double q = position.jointsRad().get(i);
      if (!limits.contains(q)) {
        return text("wouldBeOutsideItsRange", joint(i), range(limits, angle));
      }
    }
    Reach reach = reach(position, arm, installation);
    if (reach.q().isEmpty()) {
      return text("sentence", reach.text());
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limits = arm.joints().get(i);
      double q = position.jointsRad().get(i);
      if (q - limits.lowestRad() < NEAR_RAD || limits.highestRad() - q < NEAR_RAD) {
        return text(
            "isNearTheEndOfItsRange", joint(i), angle.words(NEAR_RAD), range(limits, angle));
      }
    }
    return reach.text().isEmpty() ? "" : text("sentence", reach.text());
  }

  private static String range(JointLimits limits, Measure angle) {
    return text("fromTo", angle.text(limits.lowestRad()), angle.words(limits.highestRad()));
  }
}
