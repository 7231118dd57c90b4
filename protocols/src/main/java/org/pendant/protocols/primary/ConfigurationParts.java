package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.DhConversion;

/**
 * Configuration parts of a full robot state, which never change: kinematics (type 5) and
 * configuration (type 6).
 */
final class ConfigurationParts {
  static final int KINEMATICS_BYTES = 225;
  static final int CONFIGURATION_BYTES = 445;

  private static final byte KINEMATICS = 5;
  private static final byte CONFIGURATION = 6;

  /** What is sent for a joint that turns without end, rad. */
  private static final double ENDLESS_RAD = 1e6;

  /** How much faster than its largest speed a joint may turn, rad/s. */
  private static final double BEYOND_SPEED_RAD_PER_S = 0.2;

  private static final double MAX_ACCELERATION_RAD_PER_S2 = 40;
  private static final double DEFAULT_JOINT_SPEED_RAD_PER_S = Math.toRadians(60);
  private static final double DEFAULT_JOINT_ACCELERATION_RAD_PER_S2 = Math.toRadians(80);
  private static final double DEFAULT_TOOL_SPEED_M_PER_S = 0.25;
  private static final double DEFAULT_TOOL_ACCELERATION_M_PER_S2 = 1.2;
  private static final double EQUIVALENT_RADIUS_M = 0.25;

  private static final int MASTERBOARD_VERSION = 6;
  private static final int CONTROLLER_BOX_TYPE = 4;
  private static final int ROBOT_SUB_TYPE = 3;

  private ConfigurationParts() {}

  /** Calibration of the arm: checksums, lengths and angles of its chain, and a status. */
  static byte[] kinematics(ArmDescription arm) {
    Calibration calibration = arm.calibration();
    DhParameters chain = DhConversion.parameters(arm);
    ByteBuffer out = ByteBuffer.allocate(KINEMATICS_BYTES);
    out.putInt(KINEMATICS_BYTES).put(KINEMATICS);
    calibration.jointChecksums().forEach(out::putInt);
    put(out, chain.thetaRad());
    put(out, chain.aM());
    put(out, chain.dM());
    put(out, chain.alphaRad());
    out.putInt(calibration.status().number());
    return out.array();
  }

  /** Limits, defaults and kind of the arm. */
  static byte[] configuration(ArmDescription arm) {
    ByteBuffer out = ByteBuffer.allocate(CONFIGURATION_BYTES);
    out.putInt(CONFIGURATION_BYTES).put(CONFIGURATION);
    for (JointLimits joint : arm.joints()) {
      out.putDouble(joint.unlimited() ? -ENDLESS_RAD : joint.lowestRad())
          .putDouble(joint.unlimited() ? ENDLESS_RAD : joint.highestRad());
    }
    for (JointLimits joint : arm.joints()) {
      out.putDouble(joint.maxSpeedRadPerS() + BEYOND_SPEED_RAD_PER_S)
          .putDouble(MAX_ACCELERATION_RAD_PER_S2);
    }
    out.putDouble(DEFAULT_JOINT_SPEED_RAD_PER_S)
        .putDouble(DEFAULT_JOINT_ACCELERATION_RAD_PER_S2)
        .putDouble(DEFAULT_TOOL_SPEED_M_PER_S)
        .putDouble(DEFAULT_TOOL_ACCELERATION_M_PER_S2)
        .putDouble(EQUIVALENT_RADIUS_M);
    DhParameters model = arm.dh().parameters();
    put(out, model.aM());
    put(out, model.dM());
    put(out, model.alphaRad());
    put(out, model.thetaRad());
    out.putInt(MASTERBOARD_VERSION)
        .putInt(CONTROLLER_BOX_TYPE)
        .putInt(robotType(arm.id()))
        .putInt(ROBOT_SUB_TYPE);
    return out.array();
  }

  /** The number of an arm model; those that are made from another one share its number. */
  static int robotType(String armId) {
    return switch (armId) {
      case "ur5", "ur5e", "ur7e" -> 1;
      case "ur10", "ur10e", "ur12e" -> 2;
      case "ur3", "ur3e" -> 3;
      case "ur16e" -> 4;
      case "ur18" -> 5;
      case "ur8long" -> 6;
      case "ur20" -> 7;
      case "ur30" -> 8;
      case "ur15" -> 9;
      default -> throw new IllegalArgumentException("arm " + armId + " has no robot type");
    };
  }

  private static void put(ByteBuffer out, Joints values) {
    for (int i = 0; i < Joints.COUNT; i++) {
      out.putDouble(values.get(i));
    }
  }
}
