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
    addTcp(list);
    addElbow(list);
    addForces(list);
  }

  private static void addTcp(QuantityList list) {
    list.pose("target_tcp", "TCP/Target pose", s -> s.geometry().targetTcpInBase())
        .rtde("target_TCP_pose");
    list.pose("actual_tcp", "TCP/Actual pose", s -> s.geometry().actualTcpInBase())
        .rtde("actual_TCP_pose");
    list.number("tcp_speed", "TCP/Speed", "length", METRE_PER_SECOND, ToolQuantities::tcpSpeed);
    list.velocity("tcp_velocity", "tcp_speed", "TCP/Speed", s -> s.geometry().actual().speed())
        .rtde("actual_TCP_speed");
    list.acceleration(
            "tcp_acceleration", "TCP/Acceleration", s -> s.geometry().actual().acceleration())
        .rtde("actual_TCP_acceleration");
    list.velocity(
            "target_tcp_velocity",
            "target_tcp_speed",
            "TCP/Target speed",
            s -> s.geometry().target().speed())
        .rtde("target_TCP_speed");
    list.acceleration(
            "target_tcp_acceleration",
            "TCP/Target acceleration",
            s -> s.geometry().target().acceleration())
        .rtde("target_TCP_acceleration");
    list.pose("tcp_offset", "TCP/Offset", s -> s.arm().tool().inFlange())
        .explained("The TCP in the frame of the flange")
        .rtde("tcp_offset");
    list.axes(
            "tool_acceleration",
            "TCP/Accelerometer",
            "x y z",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().toolAcceleration().xMPerS2(),
                s -> s.readings().toolAcceleration().yMPerS2(),
                s -> s.readings().toolAcceleration().zMPerS2()))
        .explained("What the sensor in the flange reads along the flange's axes")
        .rtde("actual_tool_accelerometer");
    list.number("dexterity", "TCP", "Dexterity", PhysicalUnit.NONE, ToolQuantities::dexterity)
        .explained("0 in a singularity; goes with the determinant of the Jacobian");
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
            "Elbow/Position",
            "x y z",
            METRE,
            List.of(
                s -> s.geometry().actual().elbowM().x(),
                s -> s.geometry().actual().elbowM().y(),
                s -> s.geometry().actual().elbowM().z()))
        .rtde("elbow_position");
    list.axes(
            "elbow_speed",
            "Elbow/Speed",
            "x y z",
            METRE_PER_SECOND,
            List.of(
                s -> s.geometry().actual().elbowSpeedMPerS().x(),
                s -> s.geometry().actual().elbowSpeedMPerS().y(),
                s -> s.geometry().actual().elbowSpeedMPerS().z()))
        .rtde("elbow_velocity");
  }

  private static void addForces(QuantityList list) {
    list.number("tcp_force", "TCP/Force", "length", NEWTON, ToolQuantities::tcpForce)
        .rtde("tcp_force_scalar");
    list.wrench("tcp_wrench", "tcp", "TCP/Force", s -> s.readings().flangeWrenchInBase())
        .rtde("actual_TCP_force");
    list.wrench("raw_wrench", "raw", "Forces/Raw", s -> s.readings().rawFlangeWrench())
        .explained("What the sensor feels, with the payload's weight, along the flange's axes")
        .rtde("ft_raw_wrench");
    list.wrench(
            "current_wrench",
            "current",
            "Forces/From currents",
            s -> s.geometry().flangeWrenchFromCurrents())
        .explained("What at the flange would explain the external torques of the joints")
        .rtde("wrench_calc_from_currents");
    list.wrench("base_wrench", "base", "Forces/Base", s -> s.geometry().targetBaseWrench())
        .explained("With what the base holds arm and payload in the target motion")
        .rtde("target_base_wrench");
    list.number("deviation", "Forces", "Deviation", RATIO, s -> s.readings().deviationRatio())
        .explained("Distance from the target as a part of what stops the arm")
        .rtde("joint_position_deviation_ratio");
    list.number("collision", "Forces", "Collision", RATIO, s -> s.readings().collisionRatio())
        .explained("Push from outside as a part of what stops the arm")
        .rtde("collision_detection_ratio");
  }

  private static double tcpForce(ControllerState state) {
    Wrench wrench = state.readings().flangeWrenchInBase();
    return length(wrench.fx(), wrench.fy(), wrench.fz());
  }
}
