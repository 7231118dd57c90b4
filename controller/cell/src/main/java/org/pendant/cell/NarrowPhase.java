package org.pendant.cell;

import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;

/** Narrow phase: where two parts of bodies touch whose bounds do. */
final class NarrowPhase {
  /** Places at which two bodies hold each other at most; a box on a table needs four. */
  static final int MAX_PLACES = 4;

  private final ConvexContacts convex = new ConvexContacts();
  private final HullContacts hulls = new HullContacts();

  /** A buffer for {@link #find}. */
  static DContactGeomBuffer buffer() {
    return new DContactGeomBuffer(MAX_PLACES);
  }

  /**
   * Finds where two parts touch.
   *
   * @param first one of a free or kinematic body
   * @param found overwritten with the places, their normals out of the second body
   * @return how many there are
   */
  int find(BodyPart first, BodyPart second, DContactGeomBuffer found) {
    if (second.faces != null) {
      return second.faces.find(first, MAX_PLACES, found);
    }
    if (first.hull() || second.hull()) {
      return hulls.find(first, second, MAX_PLACES, found);
    }
    int count = convex.find(first.convex, first.pose, second.convex, second.pose, found);
    if (count != ConvexContacts.UNKNOWN) {
      return count;
    }
    count = PhysicsLibrary.touch(first.geom, second.geom, MAX_PLACES, found);
    return count == 0 ? 0 : convex.findAlong(deepest(found, count), found);
  }

  /** How deep two bodies are in one another, m; at most 0 where they do not touch. */
  double depthM(CellBody first, CellBody second, DContactGeomBuffer found) {
    double most = 0;
    for (BodyPart one : first.parts) {
      for (BodyPart other : second.parts) {
        int count = one.apart(other) ? 0 : find(one, other, found);
        most = count == 0 ? most : Math.max(most, deepest(found, count).depth);
      }
    }
    return most;
  }

  private static DContactGeom deepest(DContactGeomBuffer found, int count) {
    DContactGeom deepest = found.get(0);
    for (int i = 1; i < count; i++) {
      deepest = found.get(i).depth > deepest.depth ? found.get(i) : deepest;
    }
    return deepest;
  }
}
