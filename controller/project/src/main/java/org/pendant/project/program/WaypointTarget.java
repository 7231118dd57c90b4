package org.pendant.project.program;

/** Waypoint target: where a {@link MotionStep.Waypoint} is. */
public sealed interface WaypointTarget {

  /**
   * At a place that was taught.
   *
   * @param name in {@link ProgramTree#waypoints}; several nodes with one name share one place
   */
  record Fixed(String name) implements WaypointTarget {}

  /**
   * As far from where the tool is as one taught place is from another.
   *
   * @param name of the waypoint itself
   * @param from name of a taught place
   * @param to name of a taught place
   */
  record Relative(String name, String from, String to) implements WaypointTarget {}

  /**
   * Where a variable says.
   *
   * @param expression for a pose in the move's feature, or for joint positions
   */
  record Variable(String expression) implements WaypointTarget {}
}
