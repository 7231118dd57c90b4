package org.pendant.desktop.shell.start;

import java.util.Optional;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.move.Reach;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.FirstWaypoint;
import org.pendant.project.program.WaypointPosition;

/**
 * Start location: where a program moves the arm first.
 *
 * @param name of the waypoint
 * @param tcpInBase where the TCP is there
 * @param toolInFlange the TCP that was active when it was taught
 * @param jointsRad how the arm stands there; empty if it cannot
 * @param problem why the arm does not get there; empty if it does
 */
public record StartPlace(
    String name, Pose tcpInBase, Pose toolInFlange, Optional<Joints> jointsRad, String problem) {
  private static final double CLOSE_M = 0.001;
  private static final double CLOSE_RAD = Math.toRadians(0.5);

  /** Where a program goes first, for an arm; empty if its feature is not taught. */
  public static Optional<StartPlace> of(
      FirstWaypoint.Target first, Installation installation, ArmDescription arm) {
    WaypointPosition taught = first.position();
    Optional<Pose> frame =
        taught.feature().equals(WaypointPosition.BASE)
            ? Optional.of(Pose.ZERO)
            : installation.feature(taught.feature()).flatMap(FeaturePoses::pose);
    return frame.map(feature -> of(first.name(), taught, Poses.trans(feature, taught.tcp()), arm));
  }

  private static StartPlace of(
      String name, WaypointPosition taught, Pose tcpInBase, ArmDescription arm) {
    Reach reach =
        Reach.of(
            arm, new InverseKinematics(arm), tcpInBase, taught.toolInFlange(), taught.jointsRad());
    return new StartPlace(
        name,
        tcpInBase,
        taught.toolInFlange(),
        reach.q(),
        reach.q().isPresent() ? "" : reach.text());
  }

  /** Whether the arm stands there: within 1 mm, 0.5 degrees, and 0.5 degrees of each joint. */
  public boolean reached(ControllerState state) {
    Joints now = state.arm().actualPositionRad();
    Pose tcp = new ForwardKinematics(state.arm().description()).tcpPose(now, toolInFlange);
    return Poses.pointDistance(tcp, tcpInBase) <= CLOSE_M
        && Poses.rotationAngle(tcp, tcpInBase) <= CLOSE_RAD
        && jointsRad.filter(wanted -> largest(now, wanted) <= CLOSE_RAD).isPresent();
  }

  /** How far the TCP is from there, m. */
  double distanceM(ControllerState state) {
    Pose tcp =
        new ForwardKinematics(state.arm().description())
            .tcpPose(state.arm().actualPositionRad(), toolInFlange);
    return Poses.pointDistance(tcp, tcpInBase);
  }

  private static double largest(Joints a, Joints b) {
    double largest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      largest = Math.max(largest, Math.abs(a.get(i) - b.get(i)));
    }
    return largest;
  }
}
