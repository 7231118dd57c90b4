package org.pendant.controller.world;

import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.pose.Transforms;

/**
 * Belt surface: that of a box of the scene which runs along its own x and carries what lies on it.
 */
public final class BeltSurface {
  private final RigidBodyWorld bodies;
  private final int box;
  private final double[] along = new double[3];
  private double speedMPerS;

  BeltSurface(RigidBodyWorld bodies, int box) {
    this.bodies = bodies;
    this.box = box;
    double[] pose = new double[Transforms.SIZE];
    bodies.pose(box, pose);
    for (int row = 0; row < 3; row++) {
      along[row] = pose[3 * row];
    }
  }

  /** Runs with that speed along the box's x, m/s, from now on. */
  public void run(double speedMPerS) {
    if (speedMPerS != this.speedMPerS) {
      this.speedMPerS = speedMPerS;
      bodies.runSurface(box, speedMPerS * along[0], speedMPerS * along[1], speedMPerS * along[2]);
    }
  }
}
