package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.pose.Transforms;

/**
 * Tool bodies: the solids on the flange among the objects that have a mass: they push them, and
 * feel them.
 */
final class ToolBodies {
  private final List<ToolBody> tool;
  private final double[][] inFlange;
  private final double[] pose12 = new double[Transforms.SIZE];
  private final double[] twist6 = new double[6];
  private final double[] wrench6 = new double[6];

  ToolBodies(List<SceneObject> bodies) {
    tool = ToolBody.of(bodies);
    inFlange = new double[tool.size()][Transforms.SIZE];
    for (int i = 0; i < inFlange.length; i++) {
      Transforms.of(tool.get(i).inFlange(), inFlange[i]);
    }
  }

  int count() {
    return inFlange.length;
  }

  /** Bodies to be added to a world. */
  List<BodyDescription> descriptions(String prefix) {
    List<BodyDescription> all = new ArrayList<>();
    for (int i = 0; i < inFlange.length; i++) {
      all.add(tool.get(i).description(prefix + i));
    }
    return all;
  }

  /**
   * Moves the bodies.
   *
   * @param flange12 the flange in the cell
   * @param flangeTwist6 how it moves, along the cell's axes
   * @param first the number of the first of the bodies
   */
  void move(double[] flange12, double[] flangeTwist6, RigidBodyWorld bodies, int first) {
    for (int i = 0; i < inFlange.length; i++) {
      Transforms.multiply(flange12, inFlange[i], pose12);
      double x = pose12[9] - flange12[9];
      double y = pose12[10] - flange12[10];
      double z = pose12[11] - flange12[11];
      twist6[0] = flangeTwist6[0] + flangeTwist6[4] * z - flangeTwist6[5] * y;
      twist6[1] = flangeTwist6[1] + flangeTwist6[5] * x - flangeTwist6[3] * z;
      twist6[2] = flangeTwist6[2] + flangeTwist6[3] * y - flangeTwist6[4] * x;
      System.arraycopy(flangeTwist6, 3, twist6, 3, 3);
      bodies.moveKinematic(first + i, pose12, twist6);
    }
  }

  /** Adds what they feel to a wrench about the flange's origin. */
  void addWrench(double[] flange12, RigidBodyWorld bodies, int first, double[] felt6) {
    for (int i = 0; i < inFlange.length; i++) {
      bodies.pose(first + i, pose12);
      bodies.wrench(first + i, wrench6);
      Gripper.add(wrench6, pose12, flange12, felt6);
    }
  }
}
