package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.cell.BodyProbe;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Vector3;

/** Zone: where a sensor sees something. Lengths in m, in the base frame. */
public sealed interface Zone {
  /**
   * A place.
   *
   * @param x m
   * @param y m
   * @param z m
   */
  record Place(double x, double y, double z) {
    Vector3 vector() {
      return new Vector3(x, y, z);
    }
  }

  /** Watches whether a body of a world is in it; empty where none can move. */
  Optional<BodyProbe> watch(ContactWorld world);

  /** Whether a point of the base frame is in it. */
  boolean holds(double x, double y, double z);

  /**
   * The beam of a light barrier.
   *
   * @param from one end
   * @param to the other end
   * @param radiusM how near to the line something has to come
   */
  record Beam(Place from, Place to, double radiusM) implements Zone {
    @Override
    public boolean holds(double x, double y, double z) {
      double alongX = to.x - from.x;
      double alongY = to.y - from.y;
      double alongZ = to.z - from.z;
      double squared = alongX * alongX + alongY * alongY + alongZ * alongZ;
      double dot = (x - from.x) * alongX + (y - from.y) * alongY + (z - from.z) * alongZ;
      double share = squared == 0 ? 0 : Math.clamp(dot / squared, 0, 1);
      return near(
          x - from.x - share * alongX,
          y - from.y - share * alongY,
          z - from.z - share * alongZ,
          radiusM);
    }

    @Override
    public Optional<BodyProbe> watch(ContactWorld world) {
      return world.watchLine(from.vector(), to.vector(), radiusM);
    }
  }

  /**
   * What a proximity sensor sees.
   *
   * @param at where it is
   * @param rangeM how far it sees
   */
  record Ball(Place at, double rangeM) implements Zone {
    @Override
    public boolean holds(double x, double y, double z) {
      return near(x - at.x, y - at.y, z - at.z, rangeM);
    }

    @Override
    public Optional<BodyProbe> watch(ContactWorld world) {
      return world.watchLine(at.vector(), at.vector(), rangeM);
    }
  }

  /**
   * A watched area: a box along the axes of the base.
   *
   * @param min its corner with the least numbers
   * @param max its corner with the greatest numbers
   */
  record Area(Place min, Place max) implements Zone {
    @Override
    public boolean holds(double x, double y, double z) {
      return x >= min.x && x <= max.x && y >= min.y && y <= max.y && z >= min.z && z <= max.z;
    }

    @Override
    public Optional<BodyProbe> watch(ContactWorld world) {
      return world.watchBox(min.vector(), max.vector());
    }
  }

  private static boolean near(double x, double y, double z, double rangeM) {
    return x * x + y * y + z * z <= rangeM * rangeM;
  }
}
