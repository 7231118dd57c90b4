package org.pendant.controller.world;

import java.util.List;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;

/** A flange that tests put somewhere in a scene, and what it feels there. */
final class ToolInWorld {
  final ContactWorld world;
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] tcp = new double[3];
  private final double[] twist = new double[6];
  private final double[] wrench = new double[6];

  /** The flange at the base's origin, at rest, the tool centre point on it. */
  ToolInWorld(Scene scene) {
    world = new ContactWorld(scene);
    at(Pose.ZERO);
  }

  /** Among {@code objects}, touching with the tool centre point. */
  static ToolInWorld among(SceneObject... objects) {
    return new ToolInWorld(new Scene(List.of(objects), Optional.empty(), List.of()));
  }

  /** With the flange at {@code pose} in the base frame. */
  ToolInWorld at(Pose pose) {
    Transforms.of(pose, flange);
    return this;
  }

  /** With the flange at a position in the base frame, not turned. */
  ToolInWorld at(double x, double y, double z) {
    return at(new Pose(x, y, z, 0, 0, 0));
  }

  /** With this velocity of the flange, m/s and rad/s. */
  ToolInWorld moving(double vx, double vy, double vz, double wx, double wy, double wz) {
    System.arraycopy(new double[] {vx, vy, vz, wx, wy, wz}, 0, twist, 0, 6);
    return this;
  }

  /** With this velocity of the flange, m/s, not turning. */
  ToolInWorld moving(double vx, double vy, double vz) {
    return moving(vx, vy, vz, 0, 0, 0);
  }

  /** With the tool centre point here in the flange's frame, m. */
  ToolInWorld tcp(double x, double y, double z) {
    System.arraycopy(new double[] {x, y, z}, 0, tcp, 0, 3);
    return this;
  }

  /** The load at the flange, along the base's axes. */
  Wrench feels() {
    world.wrench(flange, tcp, twist, wrench);
    return new Wrench(wrench[0], wrench[1], wrench[2], wrench[3], wrench[4], wrench[5]);
  }
}
