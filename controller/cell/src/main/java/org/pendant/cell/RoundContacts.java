package org.pendant.cell;

import org.ode4j.math.DMatrix3;
import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;
import org.pendant.models.pose.Rotations;

/**
 * Round contacts: more places at which cylinders and capsules touch flat things. The library finds
 * one, by which nothing stands: it would rock from one place to the next for ever. So the first
 * body is tilted a little to four sides, and where it would touch then counts as well, as deep as
 * it is there without being tilted.
 */
final class RoundContacts {
  /** A tilt, and how far it moves the outermost point at most. */
  private static final double TILT_RAD = 0.02;

  private static final double MAX_MOVE_M = 1e-3;

  /** Places nearer to each other are one, squared, m^2. */
  private static final double SAME_M2 = 4e-6;

  /** A normal that is this near to that of a flat face is that: the cosine between them. */
  private static final double FLAT = 0.995;

  private static final int MAX_PLACES = 5;

  /** Surfaces are looked for so far from a place on both sides, m. */
  private static final double RAY_M = 5e-3;

  private final DContactGeomBuffer tilted = new DContactGeomBuffer(MAX_PLACES);
  private final DMatrix3 rotation = new DMatrix3();
  private final double[] normal = new double[3];
  private final BodyRay ray = new BodyRay();
  private final double[][] places = new double[MAX_PLACES][3];
  private final double[] leaning = new double[9];
  private final double[] below = new double[3];
  private final double[] above = new double[3];
  private final double[] down = new double[3];
  private final double[] axis = new double[3];
  private final double[] turn = new double[9];

  /** Whether the library finds too few places of these two. */
  static boolean concern(CellBody one, CellBody other) {
    return (round(one) && flat(other)) || (round(other) && flat(one));
  }

  private static boolean round(CellBody body) {
    return body.description.shape() instanceof BodyShape.Cylinder
        || body.description.shape() instanceof BodyShape.Capsule;
  }

  private static boolean flat(CellBody body) {
    return round(body) || body.description.shape() instanceof BodyShape.Box;
  }

  /** Has more places in {@code found}, whose first {@code count} are known; answers how many. */
  int more(CellBody first, CellBody second, DContactGeomBuffer found, int count) {
    DContactGeom deepest = deepest(found, count);
    for (int i = 0; i < 3; i++) {
      normal[i] = deepest.normal.get(i);
      places[0][i] = deepest.pos.get(i);
    }
    if (!snap(second)) {
      snap(first);
    }
    double depth = deepest.depth;
    double angle = Math.min(TILT_RAD, MAX_MOVE_M / reach(first));
    int candidates = 1;
    for (int side = 0; side < 4; side++) {
      across(side / 2);
      if (tilt(first, second, side % 2 == 0 ? angle : -angle, places[candidates])) {
        candidates++;
      }
    }
    first.moved();
    int kept = 0;
    for (int i = 0; i < candidates; i++) {
      double here = overlap(first, second, places[i]);
      if (here > 0 && isNew(found, kept, places[i])) {
        kept = put(found, kept, places[i], here);
      }
    }
    return kept == 0 ? put(found, 0, places[0], depth) : kept;
  }

  /** Where the first body would touch if it were tilted, on it as it stands; whether it would. */
  private boolean tilt(CellBody first, CellBody second, double angle, double[] place) {
    double[] pose = first.pose;
    Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], turn);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        leaning[3 * i + j] =
            turn[3 * i] * pose[j] + turn[3 * i + 1] * pose[3 + j] + turn[3 * i + 2] * pose[6 + j];
      }
    }
    double[] r = leaning;
    first.geom.setRotation(rotation.set(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]));
    int count = PhysicsLibrary.touch(first.geom, second.geom, MAX_PLACES, tilted);
    if (count == 0) {
      return false;
    }
    DContactGeom at = deepest(tilted, count);
    for (int i = 0; i < 3; i++) {
      double back = 0;
      for (int k = 0; k < 3; k++) {
        back += turn[3 * k + i] * (at.pos.get(k) - pose[9 + k]);
      }
      place[i] = pose[9 + i] + back;
    }
    return true;
  }

  /** How deep the bodies are in one another along the normal through a place, m. */
  private double overlap(CellBody first, CellBody second, double[] place) {
    for (int i = 0; i < 3; i++) {
      below[i] = place[i] - RAY_M * normal[i];
      above[i] = place[i] + RAY_M * normal[i];
      down[i] = -normal[i];
    }
    return 2 * RAY_M
        - ray.enters(first.geom, below, normal, 2 * RAY_M)
        - ray.enters(second.geom, above, down, 2 * RAY_M);
  }

  private static boolean isNew(DContactGeomBuffer found, int kept, double[] place) {
    for (int i = 0; i < kept; i++) {
      double square = 0;
      for (int k = 0; k < 3; k++) {
        double way = found.get(i).pos.get(k) - place[k];
        square += way * way;
      }
      if (square < SAME_M2) {
        return false;
      }
    }
    return true;
  }

  private int put(DContactGeomBuffer found, int at, double[] place, double depth) {
    DContactGeom contact = found.get(at);
    contact.pos.set(place[0], place[1], place[2]);
    contact.normal.set(normal[0], normal[1], normal[2]);
    contact.depth = depth;
    return at + 1;
  }

  private static DContactGeom deepest(DContactGeomBuffer found, int count) {
    DContactGeom deepest = found.get(0);
    for (int i = 1; i < count; i++) {
      deepest = found.get(i).depth > deepest.depth ? found.get(i) : deepest;
    }
    return deepest;
  }

  /** Takes the normal of a flat face of a body instead, where it is nearly that. */
  private boolean snap(CellBody body) {
    boolean box = body.description.shape() instanceof BodyShape.Box;
    boolean cylinder = body.description.shape() instanceof BodyShape.Cylinder;
    for (int face = box ? 0 : 2; (box || cylinder) && face < 3; face++) {
      double[] pose = body.pose;
      double dot = normal[0] * pose[face] + normal[1] * pose[3 + face] + normal[2] * pose[6 + face];
      if (Math.abs(dot) > FLAT) {
        for (int k = 0; k < 3; k++) {
          normal[k] = Math.signum(dot) * pose[3 * k + face];
        }
        return true;
      }
    }
    return false;
  }

  /** One of two directions at right angles to the normal. */
  private void across(int which) {
    int small = Math.abs(normal[0]) < 0.6 ? 0 : 1;
    double x = small == 0 ? 0 : normal[2];
    double y = small == 0 ? -normal[2] : 0;
    double z = small == 0 ? normal[1] : -normal[0];
    double length = Math.sqrt(x * x + y * y + z * z);
    axis[0] = x / length;
    axis[1] = y / length;
    axis[2] = z / length;
    if (which == 1) {
      double ax = normal[1] * axis[2] - normal[2] * axis[1];
      double ay = normal[2] * axis[0] - normal[0] * axis[2];
      double az = normal[0] * axis[1] - normal[1] * axis[0];
      axis[0] = ax;
      axis[1] = ay;
      axis[2] = az;
    }
  }

  private static double reach(CellBody body) {
    return switch (body.description.shape()) {
      case BodyShape.Box(double x, double y, double z) -> Math.sqrt(x * x + y * y + z * z) / 2;
      case BodyShape.Sphere(double r) -> r;
      case BodyShape.Cylinder(double r, double length) -> Math.hypot(r, length / 2);
      case BodyShape.Capsule(double r, double length) -> r + length / 2;
      case BodyShape.Hull hull -> hull.hull().reachM();
      case BodyShape.HalfSpace(), BodyShape.Faces(_) -> 1;
    };
  }
}
