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
    list.group("joints");
    list.joints("target_q", "targetPosition", RADIAN, s -> s.arm().targetPositionRad())
        .rtde("target_q");
    list.joints("target_qd", "targetSpeed", RADIAN_PER_SECOND, s -> s.arm().targetSpeedRadPerS())
        .rtde("target_qd");
    list.joints(
            "target_qdd",
            "targetAcceleration",
            RADIAN_PER_SECOND_SQUARED,
            s -> s.arm().targetAccelerationRadPerS2())
        .rtde("target_qdd");
    // recorded arms repeat the target in the controller's output
    list.joints("target_current", "targetCurrent", AMPERE, s -> s.readings().targetCurrentA())
        .rtde("target_current", "joint_control_output");
    list.joints("target_torque", "targetTorque", NEWTON_METRE, s -> s.readings().targetTorqueNm())
        .rtde("target_moment");
    list.joints("actual_q", "actualPosition", RADIAN, s -> s.arm().actualPositionRad())
        .rtde("actual_q");
    list.joints("actual_qd", "actualSpeed", RADIAN_PER_SECOND, s -> s.arm().actualSpeedRadPerS())
        .rtde("actual_qd");
    list.joints(
        "actual_qdd",
        "actualAcceleration",
        RADIAN_PER_SECOND_SQUARED,
        s -> s.readings().accelerationRadPerS2());
    list.joints("current", "current", AMPERE, s -> s.readings().currentA()).rtde("actual_current");
    list.joints(
            "current_window",
            "currentWindow",
            ScalarType.DOUBLE,
            AMPERE,
            SupplyReadings::currentWindowA)
        .explained("currentWindowExplained")
        .rtde("actual_current_window");
    list.joints("torque", "torque", NEWTON_METRE, s -> s.readings().torqueNm())
        .rtde("actual_current_as_torque");
    list.joints(
            "external_torque", "externalTorque", NEWTON_METRE, s -> s.readings().externalTorqueNm())
        .explained("externalTorqueExplained");
    list.joints("temperature", "temperature", CELSIUS, s -> s.readings().temperatureC())
        .rtde("joint_temperatures");
    list.joints("joint_voltage", "voltage", VOLT, s -> s.readings().voltages().jointV())
        .rtde("actual_joint_voltage");
    list.joints(
            "joint_mode",
            "mode",
            ScalarType.INT32,
            NONE,
            (s, joint) -> RobotBits.jointMode(s, joint).code())
        .rtde("joint_mode");
  }
}
