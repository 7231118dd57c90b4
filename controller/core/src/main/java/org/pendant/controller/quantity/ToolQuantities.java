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
    list.group("tcp");
    addTcp(list);
    list.group("elbow");
    addElbow(list);
    list.group("links");
    list.number(
            "link_distance", "nearestDistance", METRE, s -> s.geometry().linkDistances().nearestM())
        .explained("linkDistanceExplained");
    list.number(
            "object_distance", "objectDistance", METRE, s -> s.geometry().linkDistances().objectM())
        .explained("objectDistanceExplained");
    list.group("forces");
    addForces(list);
  }

  private static void addTcp(QuantityList list) {
    list.pose("target_tcp", "targetPose", s -> s.geometry().targetTcpInBase())
        .rtde("target_TCP_pose");
    list.pose("actual_tcp", "actualPose", s -> s.geometry().actualTcpInBase())
        .rtde("actual_TCP_pose");
    list.velocity("tcp_velocity", "tcp_speed", "speed", s -> s.geometry().actual().speed())
        .rtde("actual_TCP_speed");
    list.acceleration("tcp_acceleration", "acceleration", s -> s.geometry().actual().acceleration())
        .rtde("actual_TCP_acceleration");
    list.velocity(
            "target_tcp_velocity",
            "target_tcp_speed",
            "targetSpeed",
            s -> s.geometry().target().speed())
        .rtde("target_TCP_speed");
    list.acceleration(
            "target_tcp_acceleration",
            "targetAcceleration",
            s -> s.geometry().target().acceleration())
        .rtde("target_TCP_acceleration");
    list.pose("tcp_offset", "offset", s -> s.arm().tool().inFlange())
        .explained("offsetExplained")
        .rtde("tcp_offset");
    list.axes(
            "tool_acceleration",
            "accelerometer",
            "x y z",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().toolAcceleration().xMPerS2(),
                s -> s.readings().toolAcceleration().yMPerS2(),
                s -> s.readings().toolAcceleration().zMPerS2()))
        .explained("accelerometerExplained")
        .rtde("actual_tool_accelerometer");
    list.number("dexterity", "dexterity", PhysicalUnit.NONE, ToolQuantities::dexterity)
        .explained("dexterityExplained");
    list.wrench("tcp_wrench", "tcp", "force", s -> s.readings().flangeWrenchInBase())
        .rtde("actual_TCP_force");
    list.group("tcp", "speed");
    list.number("tcp_speed", "length", METRE_PER_SECOND, ToolQuantities::tcpSpeed);
    list.group("tcp", "force");
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
            "position",
            "x y z",
            METRE,
            List.of(
                s -> s.geometry().actual().elbowM().x(),
                s -> s.geometry().actual().elbowM().y(),
                s -> s.geometry().actual().elbowM().z()))
        .rtde("elbow_position");
    list.axes(
            "elbow_speed",
            "speed",
            "x y z",
            METRE_PER_SECOND,
            List.of(
                s -> s.geometry().actual().elbowSpeedMPerS().x(),
                s -> s.geometry().actual().elbowSpeedMPerS().y(),
                s -> s.geometry().actual().elbowSpeedMPerS().z()))
        .rtde("elbow_velocity");
  }

  private static void addForces(QuantityList list) {
    list.wrench("raw_wrench", "raw", "raw", s -> s.readings().rawFlangeWrench())
        .explained("rawExplained")
        .rtde("ft_raw_wrench");
    list.wrench(
            "current_wrench",
            "current",
            "fromCurrents",
            s -> s.geometry().flangeWrenchFromCurrents())
        .explained("fromCurrentsExplained")
        .rtde("wrench_calc_from_currents");
    list.wrench("base_wrench", "base", "base", s -> s.geometry().targetBaseWrench())
        .explained("baseForceExplained")
        .rtde("target_base_wrench");
    list.number("deviation", "deviation", RATIO, s -> s.readings().deviationRatio())
        .explained("deviationExplained")
        .rtde("joint_position_deviation_ratio");
    list.number("collision", "collision", RATIO, s -> s.readings().collisionRatio())
        .explained("collisionExplained")
        .rtde("collision_detection_ratio");
  }

  private static double tcpForce(ControllerState state) {
    Wrench wrench = state.readings().flangeWrenchInBase();
    return length(wrench.fx(), wrench.fy(), wrench.fz());
  }
}
