package org.pendant.controller.world;

import org.pendant.cell.BodyShape;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.SolidMass;
import org.pendant.models.mesh.TriangleMesh;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Mesh body: a mesh as a body that moves. It touches with its convex hull, and its mass is spread
 * as in the solid that it is. The body has its origin at the centre of gravity and the principal
 * axes, which are not those of the file: this leads from one frame to the other.
 */
final class MeshBody implements BodyFrame {
  private final BodyShape.Hull shape;

  /** The frame of the body in that of the file, and the other way round. */
  private final double[] bodyInFile12 = new double[Transforms.SIZE];

  private final double[] fileInBody12 = new double[Transforms.SIZE];

  /**
   * The body of a mesh.
   *
   * @throws IllegalArgumentException if it cannot be one; the message says why
   */
  MeshBody(TriangleMesh mesh) {
    try {
      SolidMass mass = mesh.mass();
      mass.principalFrame(bodyInFile12);
      Transforms.invert(bodyInFile12, fileInBody12);
      shape =
          new BodyShape.Hull(
              mesh.hull().seenFrom(bodyInFile12),
              mass.momentM2(0),
              mass.momentM2(1),
              mass.momentM2(2));
    } catch (MeshException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public BodyShape.Hull shape() {
    return shape;
  }

  @Override
  public Pose ofFile(Pose fileInBase) {
    return BodyFrame.times(fileInBase, bodyInFile12);
  }

  @Override
  public void toFile(double[] body12, double[] file12) {
    Transforms.multiply(body12, fileInBody12, file12);
  }
}
