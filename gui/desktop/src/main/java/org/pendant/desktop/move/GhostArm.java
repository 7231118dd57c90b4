package org.pendant.desktop.move;

import java.util.Optional;
import org.pendant.models.arm.Joints;

/** Ghost arm: where the arm would be at the goal that the user types: for a picture of it. */
@FunctionalInterface
public interface GhostArm {
  /** Shows nothing. */
  GhostArm NONE = goal -> {};

  /**
   * The goal has changed.
   *
   * @param goalRad joint positions, rad; empty when there is nothing to show
   */
  void show(Optional<Joints> goalRad);
}
