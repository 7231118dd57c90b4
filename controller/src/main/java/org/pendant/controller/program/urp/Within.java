package org.pendant.controller.program.urp;

import java.util.OptionalDouble;
import org.pendant.controller.program.MoveKind;
import org.pendant.controller.program.WaypointPosition;

/**
 * What the move around a node says of it.
 *
 * @param feature our name of it
 * @param blendRadiusM of waypoints that have none of their own
 */
record Within(
    MoveKind kind, double speed, double acceleration, String feature, OptionalDouble blendRadiusM) {
  /** No move is around the node. */
  static final Within NOTHING =
      new Within(MoveKind.JOINT, 0, 0, WaypointPosition.BASE, OptionalDouble.empty());

  Within without() {
    return new Within(kind, speed, acceleration, feature, OptionalDouble.empty());
  }
}
