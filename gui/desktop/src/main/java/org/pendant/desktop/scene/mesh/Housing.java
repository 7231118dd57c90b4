package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4fc;
import org.joml.Vector3f;

/**
 * Housing: the round body over one joint, along the z axis of its frame: z = 0 is the face that the
 * next link turns on, at z = length the body ends.
 */
final class Housing {
  private static final double EDGE_M = 0.0012;

  /** Lids are this much narrower than what they close. */
  private static final double LID_STEP_M = 5e-4;

  private static final double GROOVE_M = 0.0016;

  /** The middle of a lid is sunk, with a slope around it. */
  private static final double RING_SHARE = 0.6;

  private static final double RING_EDGE_M = 0.0012;
  private static final double RING_DEPTH_M = 0.0014;

  private final Matrix4fc frame;
  private final double radiusM;
  private final double lengthM;

  Housing(Matrix4fc frame, double radiusM, double lengthM) {
    this.frame = frame;
    this.radiusM = radiusM;
    this.lengthM = lengthM;
  }

  /** Closes it with a cover that leaves a groove. */
  void addWithLid(MeshBuilder mesh, double lidM) {
    double seamM = lengthM - lidM;
    mesh.at(frame).finish(Finish.SHELL);
    Lathe.cylinder(mesh, radiusM, 0, seamM - GROOVE_M, EDGE_M, Lathe.AROUND);
    mesh.finish(Finish.SEAL);
    Lathe.cylinder(mesh, radiusM - 0.003, seamM - 2 * GROOVE_M, seamM + GROOVE_M, 0, Lathe.AROUND);
    mesh.finish(Finish.LID);
    double r = radiusM - LID_STEP_M;
    double roundingM = Math.min(0.3 * radiusM, 0.75 * lidM);
    Lathe.turn(
        mesh,
        new LatheProfile()
            .to(0, seamM)
            .to(r, seamM, EDGE_M)
            .to(r, lengthM, roundingM)
            .to(RING_SHARE * r, lengthM, RING_EDGE_M)
            .to(RING_SHARE * r - RING_EDGE_M, lengthM - RING_DEPTH_M, RING_EDGE_M)
            .to(0, lengthM - RING_DEPTH_M));
  }

  /** Rounds its end, as of an elbow. */
  void addWithDome(MeshBuilder mesh, double roundingM) {
    mesh.at(frame).finish(Finish.SHELL);
    Lathe.turn(
        mesh,
        new LatheProfile()
            .to(0, 0)
            .to(radiusM, 0, EDGE_M)
            .to(radiusM, lengthM, roundingM)
            .to(0, lengthM));
  }

  /**
   * What tubes may grow out of.
   *
   * @param lidM height of the lid, m: it is left free
   * @param roundingM of the edges, m
   */
  Barrel barrel(double lidM, double roundingM) {
    double freeM = lidM > 0 ? lengthM - lidM - GROOVE_M : lengthM;
    Vector3f centre = frame.transformPosition(new Vector3f(0, 0, (float) freeM / 2));
    Vector3f axis = frame.transformDirection(new Vector3f(0, 0, 1));
    return new Barrel(centre, axis, radiusM, freeM / 2, roundingM);
  }
}
