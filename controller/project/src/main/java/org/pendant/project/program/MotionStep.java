package org.pendant.project.program;

import java.util.OptionalDouble;

/** Motion node: moves the arm, or belongs to a move. */
public sealed interface MotionStep extends Step {

  /**
   * Holds waypoints, circles and directions, and says how they are gone to.
   *
   * @param kind which sort of path
   * @param speed of the leading joint in rad/s for {@link MoveKind#JOINT}, else of the tool in m/s
   * @param acceleration in rad/s² or m/s² in the same way
   * @param tool which TCP is meant
   * @param feature in which new waypoints are taught and variable ones are given; {@code Base},
   *     {@code Tool} or one of the installation
   * @param byJoints go to the joint positions that were taught, not to the pose; only for {@link
   *     MoveKind#JOINT}
   */
  record Move(
      MoveKind kind,
      double speed,
      double acceleration,
      ToolChoice tool,
      String feature,
      boolean byJoints)
      implements MotionStep {}

  /**
   * A place to go to. Its children may be {@link Until}.
   *
   * @param timing another one than the move's
   * @param blendRadiusM of the corner at the waypoint; empty for a stop there
   */
  record Waypoint(WaypointTarget target, Timing timing, OptionalDouble blendRadiusM)
      implements MotionStep {}

  /**
   * An arc in a {@link MoveKind#PROCESS} move; its children are two waypoints, the one on the way
   * and the one at the end.
   *
   * @param fixedOrientation whether the tool keeps its orientation to the arc's tangent (mode 1 of
   *     movec), otherwise it turns evenly to that of the end
   * @param blendRadiusM of the corner at its end
   */
  record CircleMove(boolean fixedOrientation, OptionalDouble blendRadiusM) implements MotionStep {}

  /**
   * A straight way in a direction until something ends it; its children are {@link Until}.
   *
   * @param feature whose axes are meant
   * @param x of the direction; only the direction of the three counts
   * @param expression for a list or pose that begins with x, y and z, in place of these; empty for
   *     none
   * @param speedMPerS of the tool; empty for the move's
   * @param accelerationMPerS2 of the tool; empty for the move's
   */
  record Direction(
      String feature,
      double x,
      double y,
      double z,
      String expression,
      OptionalDouble speedMPerS,
      OptionalDouble accelerationMPerS2)
      implements MotionStep {
    /** A direction that three numbers say. */
    public Direction(
        String feature,
        double x,
        double y,
        double z,
        OptionalDouble speedMPerS,
        OptionalDouble accelerationMPerS2) {
      this(feature, x, y, z, "", speedMPerS, accelerationMPerS2);
    }
  }

  /** Ends the way of a direction, or the way to a waypoint, early; its children run after that. */
  record Until(UntilRule rule) implements MotionStep {}

  /** Goes to the home position of the installation. */
  record Home(double speedRadPerS, double accelerationRadPerS2, OptionalDouble timeS)
      implements MotionStep {}
}
