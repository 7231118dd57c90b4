package org.pendant.project.program.urp;

import java.util.OptionalDouble;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.WaypointPosition;

/**
 * Context of a node: what the move around it, and what comes next, say of it.
 *
 * @param feature our name of it
 * @param sharedBlendM of waypoints and circles that have none of their own
 * @param lastOfProcess whether what follows the node goes to a waypoint as another sort of move
 */
record Within(
    MoveKind kind,
    double speed,
    double acceleration,
    String feature,
    OptionalDouble sharedBlendM,
    boolean lastOfProcess) {
  /** No move is around the node. */
  static final Within NOTHING =
      new Within(MoveKind.JOINT, 0, 0, WaypointPosition.BASE, OptionalDouble.empty(), false);

  /** For the corners of a circle, whose blend is its own. */
  Within without() {
    return new Within(kind, speed, acceleration, feature, OptionalDouble.empty(), false);
  }

  Within before(boolean otherMove) {
    return otherMove == lastOfProcess
        ? this
        : new Within(kind, speed, acceleration, feature, sharedBlendM, otherMove);
  }

  /** The blend of a waypoint or circle; the last one of a process move stops before another one. */
  OptionalDouble blend(OptionalDouble own) {
    return own.isPresent() || stops() ? own : sharedBlendM;
  }

  private boolean stops() {
    return kind == MoveKind.PROCESS && lastOfProcess;
  }
}
