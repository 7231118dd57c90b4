package org.pendant.cell;

import org.ode4j.ode.DAABBC;
import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DRay;

/** Body ray: looks where the surface of a body is. */
final class BodyRay {
  private final DRay ray = PhysicsLibrary.ray();
  private final DContactGeomBuffer found = new DContactGeomBuffer(1);

  /** How far a ray goes until it enters a shape, m; infinite where it does not. */
  double enters(DGeom shape, double[] from3, double[] along3, double lengthM) {
    ray.setLength(lengthM);
    ray.set(from3[0], from3[1], from3[2], along3[0], along3[1], along3[2]);
    if (PhysicsLibrary.touch(ray, shape, 1, found) == 0) {
      return Double.POSITIVE_INFINITY;
    }
    DContactGeom first = found.get(0);
    double against =
        first.normal.get0() * along3[0]
            + first.normal.get1() * along3[1]
            + first.normal.get2() * along3[2];
    return against < 0 ? first.depth : Double.POSITIVE_INFINITY;
  }

  /** Whether the bounds of a shape are as near as that to a place. */
  static boolean near(DGeom shape, double x, double y, double z, double withinM) {
    DAABBC box = shape.getAABB();
    return x > box.getMin0() - withinM
        && x < box.getMax0() + withinM
        && y > box.getMin1() - withinM
        && y < box.getMax1() + withinM
        && z > box.getMin2() - withinM
        && z < box.getMax2() + withinM;
  }
}
