package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.METRE;
import static org.pendant.controller.quantity.PhysicalUnit.METRE_PER_SECOND;
import static org.pendant.controller.quantity.PhysicalUnit.METRE_PER_SECOND_SQUARED;
import static org.pendant.controller.quantity.PhysicalUnit.NEWTON;
import static org.pendant.controller.quantity.PhysicalUnit.RATIO;

import java.util.List;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Quantities of TCP, elbow and flange. */
final class ToolQuantities {
  private ToolQuantities() {}

  static void declareIn(QuantityList list) {
    list.group("TCP");
    addTcp(list);
    list.group("Elbow");
    addElbow(list);
    list.group("Links");
    list.number("link_distance", "Nearest distance", METRE, s -> s.geometry().linkDistanceM())
        .explained(
            "Of a link of the arm from another, from an object of the scene that stands still, or"
                + " from another arm; negative where it is inside");
    list.group("Forces");
    addForces(list);
  }

  private static void addTcp(QuantityList list) {
    list.pose("target_tcp", "Target pose", s -> s.geometry().targetTcpInBase())
        .rtde("target_TCP_pose");
    list.pose("actual_tcp", "Actual pose", s -> s.geometry().actualTcpInBase())
        .rtde("actual_TCP_pose");
    list.velocity("tcp_velocity", "tcp_speed", "Speed", s -> s.geometry().actual().speed())
        .rtde("actual_TCP_speed");
    list.acceleration("tcp_acceleration", "Acceleration", s -> s.geometry().actual().acceleration())
        .rtde("actual_TCP_acceleration");
    list.velocity(
            "target_tcp_velocity",
            "target_tcp_speed",
            "Target speed",
            s -> s.geometry().target().speed())
        .rtde("target_TCP_speed");
    list.acceleration(
            "target_tcp_acceleration",
            "Target acceleration",
            s -> s.geometry().target().acceleration())
        .rtde("target_TCP_acceleration");
    list.pose("tcp_offset", "Offset", s -> s.arm().tool().inFlange())
        .explained("The TCP in the frame of the flange")
        .rtde("tcp_offset");
    list.axes(
            "tool_acceleration",
            "Accelerometer",
            "x y z",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().toolAcceleration().xMPerS2(),
                s -> s.readings().toolAcceleration().yMPerS2(),
                s -> s.readings().toolAcceleration().zMPerS2()))
        .explained("What the sensor in the flange reads along the flange's axes")
        .rtde("actual_tool_accelerometer");
    list.number("dexterity", "Dexterity", PhysicalUnit.NONE, ToolQuantities::dexterity)
        .explained("0 in a singularity; goes with the determinant of the Jacobian");
    list.wrench("tcp_wrench", "tcp", "Force", s -> s.readings().flangeWrenchInBase())
        .rtde("actual_TCP_force");
    list.group("TCP/Speed");
    list.number("tcp_speed", "length", METRE_PER_SECOND, ToolQuantities::tcpSpeed);
    list.group("TCP/Force");
    list.number("tcp_force", "length", NEWTON, ToolQuantities::tcpForce).rtde("tcp_force_scalar");
  }

  private static double tcpSpeed(ControllerState state) {
    Pose speed = state.geometry().actual().speed();
    return length(speed.x(), speed.y(), speed.z());
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }

  private static double dexterity(ControllerState state) {
    DhLengths dh = state.arm().description().dh();
    Joints q = state.arm().actualPositionRad();
    return Singularity.SHOULDER.measure(dh, q)
        * Singularity.ELBOW.measure(dh, q)
        * Singularity.WRIST.measure(dh, q);
  }

  private static void addElbow(QuantityList list) {
    list.axes(
            "elbow",
            "Position",
            "x y z",
            METRE,
            List.of(
                s -> s.geometry().actual().elbowM().x(),
                s -> s.geometry().actual().elbowM().y(),
                s -> s.geometry().actual().elbowM().z()))
        .rtde("elbow_position");
    list.axes(
            "elbow_speed",
            "Speed",
            "x y z",
            METRE_PER_SECOND,
            List.of(
                s -> s.geometry().actual().elbowSpeedMPerS().x(),
                s -> s.geometry().actual().elbowSpeedMPerS().y(),
                s -> s.geometry().actual().elbowSpeedMPerS().z()))
        .rtde("elbow_velocity");
  }

  private static void addForces(QuantityList list) {
    list.wrench("raw_wrench", "raw", "Raw", s -> s.readings().rawFlangeWrench())
        .explained("What the sensor feels, with the payload's weight, along the flange's axes")
        .rtde("ft_raw_wrench");
    list.wrench(
            "current_wrench",
            "current",
            "From currents",
            s -> s.geometry().flangeWrenchFromCurrents())
        .explained("What at the flange would explain the external torques of the joints")
        .rtde("wrench_calc_from_currents");
    list.wrench("base_wrench", "base", "Base", s -> s.geometry().targetBaseWrench())
        .explained("With what the base holds arm and payload in the target motion")
        .rtde("target_base_wrench");
    list.number("deviation", "Deviation", RATIO, s -> s.readings().deviationRatio())
        .explained("Distance from the target as a part of what stops the arm")
        .rtde("joint_position_deviation_ratio");
    list.number("collision", "Collision", RATIO, s -> s.readings().collisionRatio())
        .explained("Push from outside as a part of what stops the arm")
        .rtde("collision_detection_ratio");
  }

  private static double tcpForce(ControllerState state) {
    Wrench wrench = state.readings().flangeWrenchInBase();
    return length(wrench.fx(), wrench.fy(), wrench.fz());
  }
}
