package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.controller.state.SupplyReadings;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Fields about joints, tool, forces, masses and supply. */
final class ArmFields {
  private ArmFields() {}

  static void addTo(FieldList list) {
    list.number("timestamp", ControllerState::timeS);
    addJoints(list);
    addTool(list);
    addForces(list);
    addMasses(list);
    addSupply(list);
  }

  private static void addJoints(FieldList list) {
    list.joints("target_q", state -> state.arm().targetPositionRad());
    list.joints("target_qd", state -> state.arm().targetSpeedRadPerS());
    list.joints("target_qdd", state -> state.arm().targetAccelerationRadPerS2());
    list.joints("target_current", state -> state.readings().targetCurrentA());
    list.joints("target_moment", state -> state.readings().targetTorqueNm());
    list.joints("actual_q", state -> state.arm().actualPositionRad());
    list.joints("actual_qd", state -> state.arm().actualSpeedRadPerS());
    list.joints("actual_current", state -> state.readings().currentA());
    list.eachJoint("actual_current_window", SupplyReadings::currentWindowA);
    list.joints("actual_current_as_torque", state -> state.readings().torqueNm());
    // the simulated drives give what is asked of them, within the same frame
    list.joints("joint_control_output", state -> state.readings().currentA());
    list.joints("joint_temperatures", state -> state.readings().temperatureC());
    list.codes("joint_mode", (state, joint) -> RobotBits.jointMode(state, joint).code());
  }

  private static void addTool(FieldList list) {
    list.pose("actual_TCP_pose", state -> state.geometry().actualTcpInBase());
    list.pose("actual_TCP_speed", state -> state.geometry().actual().speed());
    list.pose("actual_TCP_acceleration", state -> state.geometry().actual().acceleration());
    list.pose("target_TCP_pose", state -> state.geometry().targetTcpInBase());
    list.pose("target_TCP_speed", state -> state.geometry().target().speed());
    list.pose("target_TCP_acceleration", state -> state.geometry().target().acceleration());
    list.pose("tcp_offset", state -> state.arm().tool().inFlange());
    list.vector3("elbow_position", (state, out) -> put(state.geometry().actual().elbowM(), out));
    list.vector3(
        "elbow_velocity", (state, out) -> put(state.geometry().actual().elbowSpeedMPerS(), out));
    list.vector3(
        "actual_tool_accelerometer",
        (state, out) -> {
          ArmReadings.Acceleration a = state.readings().toolAcceleration();
          out.putDouble(a.xMPerS2()).putDouble(a.yMPerS2()).putDouble(a.zMPerS2());
        });
  }

  private static void addForces(FieldList list) {
    list.wrench("actual_TCP_force", state -> state.readings().flangeWrenchInBase());
    list.number("tcp_force_scalar", state -> length(state.readings().flangeWrenchInBase()));
    list.wrench("ft_raw_wrench", state -> state.readings().rawFlangeWrench());
    list.wrench("wrench_calc_from_currents", state -> state.geometry().flangeWrenchFromCurrents());
    list.wrench("target_base_wrench", state -> state.geometry().targetBaseWrench());
    list.number("joint_position_deviation_ratio", state -> state.readings().deviationRatio());
    list.number("collision_detection_ratio", state -> state.readings().collisionRatio());
  }

  private static double length(Wrench w) {
    return Math.sqrt(w.fx() * w.fx() + w.fy() * w.fy() + w.fz() * w.fz());
  }

  private static void addMasses(FieldList list) {
    list.number("actual_momentum", state -> state.readings().momentumKgMPerS());
    list.number("payload", state -> state.readings().payload().massKg());
    list.vector3(
        "payload_cog",
        (state, out) -> {
          Payload payload = state.readings().payload();
          out.putDouble(payload.cogXM()).putDouble(payload.cogYM()).putDouble(payload.cogZM());
        });
    list.add(
        "payload_inertia",
        FieldType.VECTOR6D,
        (state, out) -> {
          Payload p = state.readings().payload();
          out.putDouble(p.ixx()).putDouble(p.iyy()).putDouble(p.izz());
          out.putDouble(p.ixy()).putDouble(p.ixz()).putDouble(p.iyz());
        });
    list.vector3(
        "target_gravity",
        (state, out) -> {
          Mounting base = state.readings().mounting();
          out.putDouble(base.gravityXMPerS2());
          out.putDouble(base.gravityYMPerS2());
          out.putDouble(base.gravityZMPerS2());
        });
    list.pose(
        "target_base_acceleration",
        state -> {
          Mounting base = state.readings().mounting();
          return new Pose(
              base.accelerationXMPerS2(),
              base.accelerationYMPerS2(),
              base.accelerationZMPerS2(),
              0,
              0,
              0);
        });
  }

  private static void addSupply(FieldList list) {
    list.number("actual_main_voltage", SupplyReadings::mainV);
    list.number("actual_robot_voltage", SupplyReadings::robotV);
    list.number("actual_robot_current", state -> state.readings().robotCurrentA());
    list.eachJoint("actual_joint_voltage", SupplyReadings::jointV);
    list.number("io_current", SupplyReadings::ioCurrentA);
    list.number("actual_robot_energy_consumed", state -> state.readings().energyConsumedJ());
    list.number(
        "actual_robot_braking_energy_dissipated", state -> state.readings().energyDissipatedJ());
  }

  private static void put(Vector3 v, ByteBuffer out) {
    out.putDouble(v.x()).putDouble(v.y()).putDouble(v.z());
  }
}
