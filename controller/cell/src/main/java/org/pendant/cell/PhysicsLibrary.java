package org.pendant.cell;

import org.ode4j.ode.DContactGeomBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DRay;
import org.ode4j.ode.OdeHelper;

/**
 * Physics library: where the shapes of ode4j are made and brought together; sets the library's
 * tables up before the first. They never change afterwards, so threads need no order.
 *
 * <p>The library finds where shapes touch. Its solvers are not used: the exact one gives up in
 * symmetrical stacks, and the other draws random numbers that all worlds of a process share.
 */
final class PhysicsLibrary {
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
      case BodyShape.HalfSpace() ->
          OdeHelper.createPlane(
              null, at[2], at[5], at[8], at[2] * at[9] + at[5] * at[10] + at[8] * at[11]);
    };
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
