package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.AMPERE;
import static org.pendant.controller.quantity.PhysicalUnit.CELSIUS;
import static org.pendant.controller.quantity.PhysicalUnit.NEWTON_METRE;
import static org.pendant.controller.quantity.PhysicalUnit.NONE;
import static org.pendant.controller.quantity.PhysicalUnit.RADIAN;
import static org.pendant.controller.quantity.PhysicalUnit.RADIAN_PER_SECOND;
import static org.pendant.controller.quantity.PhysicalUnit.RADIAN_PER_SECOND_SQUARED;
import static org.pendant.controller.quantity.PhysicalUnit.VOLT;

import org.pendant.controller.state.RobotBits;
import org.pendant.controller.state.SupplyReadings;

/** Quantities that each joint has. */
final class JointQuantities {
  private JointQuantities() {}

  static void declareIn(QuantityList list) {
    list.group("Joints");
    list.joints("target_q", "Target position", RADIAN, s -> s.arm().targetPositionRad())
        .rtde("target_q");
    list.joints("target_qd", "Target speed", RADIAN_PER_SECOND, s -> s.arm().targetSpeedRadPerS())
        .rtde("target_qd");
    list.joints(
            "target_qdd",
            "Target acceleration",
            RADIAN_PER_SECOND_SQUARED,
            s -> s.arm().targetAccelerationRadPerS2())
        .rtde("target_qdd");
    // recorded arms repeat the target in the controller's output
    list.joints("target_current", "Target current", AMPERE, s -> s.readings().targetCurrentA())
        .rtde("target_current", "joint_control_output");
    list.joints("target_torque", "Target torque", NEWTON_METRE, s -> s.readings().targetTorqueNm())
        .rtde("target_moment");
    list.joints("actual_q", "Actual position", RADIAN, s -> s.arm().actualPositionRad())
        .rtde("actual_q");
    list.joints("actual_qd", "Actual speed", RADIAN_PER_SECOND, s -> s.arm().actualSpeedRadPerS())
        .rtde("actual_qd");
    list.joints(
        "actual_qdd",
        "Actual acceleration",
        RADIAN_PER_SECOND_SQUARED,
        s -> s.readings().accelerationRadPerS2());
    list.joints("current", "Current", AMPERE, s -> s.readings().currentA()).rtde("actual_current");
    list.joints(
            "current_window",
            "Current window",
            ScalarType.DOUBLE,
            AMPERE,
            SupplyReadings::currentWindowA)
        .explained("How far the current may be from what the motion needs")
        .rtde("actual_current_window");
    list.joints("torque", "Torque", NEWTON_METRE, s -> s.readings().torqueNm())
        .rtde("actual_current_as_torque");
    list.joints(
            "external_torque",
            "External torque",
            NEWTON_METRE,
            s -> s.readings().externalTorqueNm())
        .explained("What the torque has beyond the controller's model of arm and payload");
    list.joints("temperature", "Temperature", CELSIUS, s -> s.readings().temperatureC())
        .rtde("joint_temperatures");
    list.joints("joint_voltage", "Voltage", VOLT, s -> s.readings().voltages().jointV())
        .rtde("actual_joint_voltage");
    list.joints(
            "joint_mode",
            "Mode",
            ScalarType.INT32,
            NONE,
            (s, joint) -> RobotBits.jointMode(s, joint).code())
        .rtde("joint_mode");
  }
}
