package org.pendant.cell;

import org.ode4j.math.DMatrix3;
import org.ode4j.math.DVector3;
import org.ode4j.ode.DContactGeomBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DRay;
import org.ode4j.ode.DRotation;
import org.ode4j.ode.OdeHelper;
import org.pendant.models.mesh.TriangleMesh;

/**
 * Physics library: where the shapes of ode4j are made and brought together; sets the library's
 * tables up before the first. They never change afterwards, so threads need no order.
 *
 * <p>The library finds where shapes touch. Its solvers are not used: the exact one gives up in
 * symmetrical stacks, and the other draws random numbers that all worlds of a process share.
 */
final class PhysicsLibrary {
  /** The thinnest box, m. */
  private static final double THIN_M = 1e-6;

  static {
    OdeHelper.initODE2(0);
  }

  private PhysicsLibrary() {}

  /**
   * A shape. A half space stays where it is made.
   *
   * @param at where, as {@link org.pendant.models.pose.Transforms} has it
   */
  static DGeom shape(BodyShape shape, double[] at) {
    return switch (shape) {
      case BodyShape.Box(double x, double y, double z) -> OdeHelper.createBox(x, y, z);
      case BodyShape.Sphere(double radius) -> OdeHelper.createSphere(radius);
      case BodyShape.Cylinder(double radius, double length) ->
          OdeHelper.createCylinder(radius, length);
      case BodyShape.Capsule(double radius, double length) ->
          OdeHelper.createCapsule(radius, length);
      // balls around them: the library only tells what is near
      case BodyShape.Faces(TriangleMesh mesh) -> OdeHelper.createSphere(mesh.reachM());
      case BodyShape.Hull hull -> OdeHelper.createSphere(hull.hull().reachM());
      case BodyShape.Compound _ -> throw new IllegalArgumentException("must be given part by part");
      case BodyShape.HalfSpace() ->
          OdeHelper.createPlane(
              null, at[2], at[5], at[8], at[2] * at[9] + at[5] * at[10] + at[8] * at[11]);
    };
  }

  /** A ball that is swept along a line. */
  static DGeom line(double[] from3, double[] to3, double radiusM) {
    double x = to3[0] - from3[0];
    double y = to3[1] - from3[1];
    double z = to3[2] - from3[2];
    double length = Math.sqrt(x * x + y * y + z * z);
    DGeom line =
        length > 0 ? OdeHelper.createCapsule(radiusM, length) : OdeHelper.createSphere(radiusM);
    line.setPosition(from3[0] + x / 2, from3[1] + y / 2, from3[2] + z / 2);
    if (length > 0) {
      DMatrix3 along = new DMatrix3();
      DRotation.dRFromZAxis(along, new DVector3(x / length, y / length, z / length));
      line.setRotation(along);
    }
    return line;
  }

  /** A box along the axes of the base. */
  static DGeom block(double[] min3, double[] max3) {
    DGeom block =
        OdeHelper.createBox(
            Math.max(THIN_M, max3[0] - min3[0]),
            Math.max(THIN_M, max3[1] - min3[1]),
            Math.max(THIN_M, max3[2] - min3[2]));
    block.setPosition((min3[0] + max3[0]) / 2, (min3[1] + max3[1]) / 2, (min3[2] + max3[2]) / 2);
    return block;
  }

  /** A ray, to be set. */
  static DRay ray() {
    return OdeHelper.createRay(null, 1);
  }

  /** Where two shapes touch, at {@code most} places at most; answers how many. */
  static int touch(DGeom one, DGeom other, int most, DContactGeomBuffer found) {
    return OdeHelper.collide(one, other, most, found);
  }
}
