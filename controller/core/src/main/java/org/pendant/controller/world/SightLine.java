package org.pendant.controller.world;

import java.util.List;
import org.pendant.cell.BodyMotion;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.collision.SolidShape;

/**
 * Sight line: whether one sees the middle of an object from a place, or something is in between:
 * another object, or a link or a tool of an arm.
 */
public final class SightLine {
  private final FreeBodies among;
  private final List<SolidShape> still;

  SightLine(FreeBodies among, List<SceneObject> objects) {
    this.among = among;
    still =
        objects.stream()
            .filter(each -> each.massKg() == 0)
            .flatMap(each -> each.pieces().stream())
            .map(ArmSurroundings::solid)
            .toList();
  }

  /**
   * Whether nothing is in between.
   *
   * @param from in the frame of the cell, m
   * @param to the middle of the object, m
   * @param object its name, or that of a copy; it has a mass and is there
   */
  public boolean clear(Vector3 from, Vector3 to, String object) {
    Vector3 way = new Vector3(to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
    double lengthM = way.length();
    if (lengthM == 0) {
      return true;
    }
    for (SolidShape solid : still) {
      if (solid.toSegment(from.x(), from.y(), from.z(), to.x(), to.y(), to.z()) < 0) {
        return false;
      }
    }
    double[] along3 = way.unit().toArray();
    int seen = among.there(object);
    RigidBodyWorld bodies = among.bodies();
    for (int i = 0; i < bodies.size(); i++) {
      if (i != seen
          && bodies.description(i).motion() != BodyMotion.FIXED
          && bodies.enters(i, from.toArray(), along3, lengthM) < lengthM) {
        return false;
      }
    }
    return true;
  }
}
