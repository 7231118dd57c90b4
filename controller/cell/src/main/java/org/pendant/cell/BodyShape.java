package org.pendant.cell;

import java.util.List;
import org.pendant.models.json.Range;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.mesh.TriangleMesh;
import org.pendant.models.pose.Pose;

/** Body shape: what a rigid body fills, around its own origin. */
public sealed interface BodyShape {
  /** From a thin sheet to a hall. */
  Range SIZE = new Range(0.001, 10, "m");

  /**
   * A block.
   *
   * @param xM length along its own x, m, as the others 0.001 to 10
   * @param yM length along its own y, m
   * @param zM length along its own z, m
   */
  record Box(double xM, double yM, double zM) implements BodyShape {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Box {
      SIZE.require("size[0]", xM);
      SIZE.require("size[1]", yM);
      SIZE.require("size[2]", zM);
    }
  }

  /**
   * A ball.
   *
   * @param radiusM its radius, m, 0.001 to 10
   */
  record Sphere(double radiusM) implements BodyShape {
    /**
     * Checks the number.
     *
     * @throws IllegalArgumentException if it is outside its range
     */
    public Sphere {
      SIZE.require("radius", radiusM);
    }
  }

  /**
   * A round bar with flat ends, along its own z.
   *
   * @param radiusM its radius, m, 0.001 to 10
   * @param lengthM its length, m, 0.001 to 10
   */
  record Cylinder(double radiusM, double lengthM) implements BodyShape {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Cylinder {
      SIZE.require("radius", radiusM);
      SIZE.require("length", lengthM);
    }
  }

  /**
   * A round bar with half a ball at each end, along its own z.
   *
   * @param radiusM its radius, m, 0.001 to 10
   * @param lengthM its length without the ends, m, 0.001 to 10
   */
  record Capsule(double radiusM, double lengthM) implements BodyShape {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Capsule {
      SIZE.require("radius", radiusM);
      SIZE.require("length", lengthM);
    }
  }

  /**
   * A solid made of triangles. Cannot move.
   *
   * @param mesh its triangles
   */
  record Faces(TriangleMesh mesh) implements BodyShape {}

  /**
   * A solid without dents, which may move: its origin is the centre of gravity and its axes are the
   * principal ones.
   *
   * @param hull its corners and faces
   * @param xM2 moment of inertia about its own x for each kg, m^2
   * @param yM2 the same about y
   * @param zM2 the same about z
   */
  record Hull(ConvexHull hull, double xM2, double yM2, double zM2) implements BodyShape {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if it is thinner than 1 mm or longer than 10 m, or if its
     *     centre of gravity is not within it
     */
    public Hull {
      for (int axis = 0; axis < 3; axis++) {
        SIZE.require("length", hull.lengthM(axis));
      }
      for (int face = 0; face < hull.faces(); face++) {
        if (!(hull.plane(face, 3) > 0)) {
          throw new IllegalArgumentException(
              "its centre of gravity is not within its hull: its surface goes through itself");
        }
      }
    }
  }

  /**
   * Several solids that are rigidly joined, which may overlap; the body's origin is the centre of
   * gravity of all and its axes are the principal ones.
   *
   * @param parts at least one, at most {@value #MAX_PARTS}; half spaces and compounds are none, and
   *     faces are none of a body that moves
   * @param xM2 moment of inertia about its own x for each kg, m^2
   * @param yM2 the same about y
   * @param zM2 the same about z
   */
  record Compound(List<Part> parts, double xM2, double yM2, double zM2) implements BodyShape {
    /** Parts at most. */
    public static final int MAX_PARTS = 32;

    /**
     * A part.
     *
     * @param inBody where it is in the frame of the body
     */
    public record Part(BodyShape shape, Pose inBody) {}

    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException if there are none or too many, or one is no solid by itself
     */
    public Compound {
      parts = List.copyOf(parts);
      if (parts.isEmpty() || parts.size() > MAX_PARTS) {
        throw new IllegalArgumentException(
            "parts: are " + parts.size() + ", must be 1 to " + MAX_PARTS);
      }
      for (Part part : parts) {
        if (part.shape() instanceof HalfSpace || part.shape() instanceof Compound) {
          throw new IllegalArgumentException("parts: must be solids of one piece");
        }
      }
    }
  }

  /** Everything below its own z = 0: a floor, a wall. Cannot move. */
  record HalfSpace() implements BodyShape {}
}
