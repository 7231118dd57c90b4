package org.pendant.controller.world;

import org.pendant.cell.BodyShape;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Body frame: leads from the frame in which a file says where an object is to that of its body, the
 * centre of gravity with the principal axes, and back.
 */
interface BodyFrame {
  /** What the body fills in its own frame. */
  BodyShape shape();

  /** The pose of the body where that of the object in its file is known. */
  Pose ofFile(Pose fileInBase);

  /**
   * The pose of the object in its file where that of the body is known.
   *
   * @param file12 overwritten; another array
   */
  void toFile(double[] body12, double[] file12);

  /** A pose in the frame of another one. */
  static Pose times(Pose inBase, double[] inner12) {
    double[] outer12 = new double[Transforms.SIZE];
    double[] both12 = new double[Transforms.SIZE];
    Transforms.of(inBase, outer12);
    Transforms.multiply(outer12, inner12, both12);
    return Transforms.toPose(both12);
  }
}
