package org.pendant.cell;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;

/** Bodies: worlds for tests, and what they say. */
final class Bodies {
  static final double G = 9.82;
  static final double STEP_S = 0.002;
  static final BodySurface SMOOTH = new BodySurface(0, 0, 40_000);

  private Bodies() {}

  static Pose at(double x, double y, double z) {
    return new Pose(x, y, z, 0, 0, 0);
  }

  static BodyDescription floor(double friction, double restitution) {
    return BodyDescription.fixed(
        "floor",
        new BodyShape.HalfSpace(),
        Pose.ZERO,
        new BodySurface(friction, restitution, 40_000));
  }

  static BodyDescription cube(String name, double sizeM, Pose pose, double friction) {
    return BodyDescription.free(
        name,
        new BodyShape.Box(sizeM, sizeM, sizeM),
        pose,
        1,
        new BodySurface(friction, 0, 40_000));
  }

  static RigidBodyWorld upright(List<BodyDescription> bodies) {
    return new RigidBodyWorld(bodies, 0, 0, -G);
  }

  /** A floor and a tower of boxes, 0.1 m each, a little askew. */
  static RigidBodyWorld tower(int boxes) {
    List<BodyDescription> bodies = new ArrayList<>();
    bodies.add(floor(0.5, 0));
    for (int i = 0; i < boxes; i++) {
      Pose pose = at(0.002 * (i % 3), -0.002 * (i % 2), 0.05 + 0.1 * i);
      bodies.add(cube("box " + i, 0.1, pose, 0.5));
    }
    return upright(bodies);
  }

  /** A heap of all shapes that falls on the floor, and a kinematic plate that sweeps through it. */
  static RigidBodyWorld heap() {
    List<BodyDescription> bodies = new ArrayList<>();
    bodies.add(floor(0.4, 0.2));
    bodies.add(
        BodyDescription.kinematic(
            "plate", new BodyShape.Box(0.02, 1, 0.2), at(-0.6, 0, 0.1), BodySurface.DEFAULT));
    for (int i = 0; i < 20; i++) {
      BodyShape shape =
          switch (i % 4) {
            case 0 -> new BodyShape.Box(0.08, 0.1, 0.06);
            case 1 -> new BodyShape.Sphere(0.04);
            case 2 -> new BodyShape.Cylinder(0.04, 0.08);
            default -> new BodyShape.Capsule(0.03, 0.06);
          };
      Pose pose =
          new Pose(
              0.15 * (i % 3) - 0.15, 0.01 * i, 0.2 + 0.12 * Math.floorDiv(i, 3), 0.3 * i, 0.2, 0);
      bodies.add(BodyDescription.free("part " + i, shape, pose, 0.5 + i, BodySurface.DEFAULT));
    }
    return upright(bodies);
  }

  /** One step of the heap; the plate sweeps. */
  static void sweep(RigidBodyWorld heap, int step) {
    double x = -0.6 + 0.5 * step * STEP_S;
    heap.moveKinematic(
        1, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0, 0.1}, new double[] {0.5, 0, 0, 0, 0, 0});
    heap.advance(STEP_S);
  }

  /** All poses, as bits. */
  static List<Long> bits(RigidBodyWorld world) {
    List<Long> bits = new ArrayList<>();
    double[] pose = new double[12];
    for (int i = 0; i < world.size(); i++) {
      world.pose(i, pose);
      for (double each : pose) {
        bits.add(Double.doubleToRawLongBits(each));
      }
    }
    return bits;
  }

  static void run(RigidBodyWorld world, double timeS) {
    for (long i = Math.round(timeS / STEP_S); i > 0; i--) {
      world.advance(STEP_S);
    }
  }

  static double[] pose(RigidBodyWorld world, int body) {
    double[] pose = new double[12];
    world.pose(body, pose);
    return pose;
  }

  static double[] velocity(RigidBodyWorld world, int body) {
    double[] twist = new double[6];
    world.velocity(body, twist);
    return twist;
  }
}
