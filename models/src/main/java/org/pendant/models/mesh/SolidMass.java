package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import org.pendant.models.pose.Transforms;

/**
 * Solid mass: how the mass of a solid is spread that is the same everywhere in it: where its centre
 * of gravity is, and its principal axes of inertia. Immutable.
 *
 * <p>Sums over the tetrahedra between the centre and each triangle, as F. Tonon has them in
 * "Explicit Exact Formulas for the 3-D Tetrahedron Inertia Tensor" (2005).
 */
public final class SolidMass {
  private final double[] frame = new double[Transforms.SIZE];
  private final double[] squaresM2 = new double[3];

  /** Of a mesh. */
  SolidMass(TriangleMesh mesh) throws MeshException {
    double[] first = new double[3];
    double volume = 0;
    double[] origin = corner(mesh, 0, 0);
    for (int i = 0; i < mesh.triangles(); i++) {
      double six = sixVolumes(mesh, i, origin);
      volume += six;
      for (int axis = 0; axis < 3; axis++) {
        first[axis] += six * (sum(mesh, i, axis) - 3 * origin[axis]) / 4;
      }
    }
    double[] centre = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      centre[axis] = origin[axis] + first[axis] / volume;
    }
    double[] second = new double[9];
    for (int i = 0; i < mesh.triangles(); i++) {
      double share = sixVolumes(mesh, i, centre) / volume / 20;
      for (int a = 0; a < 3; a++) {
        for (int b = a; b < 3; b++) {
          double products = 0;
          for (int k = 0; k < 3; k++) {
            products += at(mesh, i, k, a, centre) * at(mesh, i, k, b, centre);
          }
          double sums = (sum(mesh, i, a) - 3 * centre[a]) * (sum(mesh, i, b) - 3 * centre[b]);
          second[3 * a + b] += share * (products + sums);
        }
      }
    }
    second[3] = second[1];
    second[6] = second[2];
    second[7] = second[5];
    PrincipalAxes.turn(second, frame);
    System.arraycopy(centre, 0, frame, 9, 3);
    for (int axis = 0; axis < 3; axis++) {
      squaresM2[axis] = second[4 * axis];
      if (!(squaresM2[axis] > 0)) {
        throw new MeshException(text("throughItself"));
      }
    }
  }

  /**
   * The principal axes at the centre of gravity.
   *
   * @param frame12 overwritten with their frame in that of the mesh, as {@link Transforms} has it
   */
  public void principalFrame(double[] frame12) {
    System.arraycopy(frame, 0, frame12, 0, Transforms.SIZE);
  }

  /** Where the centre of gravity is along an axis of the mesh, m. */
  public double centreM(int axis) {
    return frame[9 + axis];
  }

  /** The moment of inertia about a principal axis for each kg, m^2. */
  public double momentM2(int axis) {
    return squaresM2[(axis + 1) % 3] + squaresM2[(axis + 2) % 3];
  }

  private static double[] corner(TriangleMesh mesh, int triangle, int corner) {
    int point = mesh.corner(triangle, corner);
    return new double[] {
      mesh.coordinate(point, 0), mesh.coordinate(point, 1), mesh.coordinate(point, 2)
    };
  }

  private static double at(TriangleMesh mesh, int triangle, int corner, int axis, double[] from) {
    return mesh.coordinate(mesh.corner(triangle, corner), axis) - from[axis];
  }

  private static double sum(TriangleMesh mesh, int triangle, int axis) {
    return mesh.coordinate(mesh.corner(triangle, 0), axis)
        + mesh.coordinate(mesh.corner(triangle, 1), axis)
        + mesh.coordinate(mesh.corner(triangle, 2), axis);
  }

  private static double sixVolumes(TriangleMesh mesh, int triangle, double[] from) {
    double[] a = corner(mesh, triangle, 0);
    double[] b = corner(mesh, triangle, 1);
    double[] c = corner(mesh, triangle, 2);
    for (int axis = 0; axis < 3; axis++) {
      a[axis] -= from[axis];
      b[axis] -= from[axis];
      c[axis] -= from[axis];
    }
    return a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
}
