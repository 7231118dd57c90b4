package org.pendant.desktop.program.form;

import org.pendant.kit.form.Measure;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.project.program.MoveKind;

/** How fast moves may be, and what a new one is like. */
record Ranges(ArmDescription arm) {
  /** A joint move as it is made at first: 60 deg/s. */
  static final double JOINT_SPEED_RAD_PER_S = Math.toRadians(60);

  /** A joint move as it is made at first: 80 deg/s². */
  static final double JOINT_ACCELERATION_RAD_PER_S2 = Math.toRadians(80);

  /** A straight move as it is made at first. */
  static final double TOOL_SPEED_M_PER_S = 0.25;

  /** A straight move as it is made at first. */
  static final double TOOL_ACCELERATION_M_PER_S2 = 1.2;

  private static final double MAX_JOINT_ACCELERATION_RAD_PER_S2 = 40;
  private static final double MAX_TOOL_SPEED_M_PER_S = 5;
  private static final double MAX_TOOL_ACCELERATION_M_PER_S2 = 150;

  static Measure speed(boolean joint) {
    return joint ? Measure.DEGREE_PER_S : Measure.MILLIMETRE_PER_S;
  }

  static Measure acceleration(boolean joint) {
    return joint ? Measure.DEGREE_PER_S2 : Measure.MILLIMETRE_PER_S2;
  }

  Range speeds(boolean joint) {
    return Range.upTo(joint ? fastestJoint() : MAX_TOOL_SPEED_M_PER_S);
  }

  static Range accelerations(boolean joint) {
    return Range.upTo(joint ? MAX_JOINT_ACCELERATION_RAD_PER_S2 : MAX_TOOL_ACCELERATION_M_PER_S2);
  }

  private double fastestJoint() {
    return arm.joints().stream().mapToDouble(JointLimits::maxSpeedRadPerS).max().orElse(Math.PI);
  }

  static boolean joint(MoveKind kind) {
    return kind == MoveKind.JOINT;
  }

  /** What people call a sort of path. */
  static String words(MoveKind kind) {
    return switch (kind) {
      case JOINT -> "MoveJ";
      case LINEAR -> "MoveL";
      case PROCESS -> "MoveP";
    };
  }
}
