package org.pendant.cell;

import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;

/** Touch candidates: places where two bodies may hold each other, of which a few are chosen. */
final class TouchCandidates {
  /** Candidates at most; more of a dense mesh tell nothing new. */
  private static final int MAX_CANDIDATES = 64;

  /** Places to be chosen at most. */
  private static final int MAX_CHOSEN = 4;

  /**
   * An earlier candidate counts as the deepest unless a later one is so much deeper, m: that of
   * bodies at rest, so that they stand on places that stay, whose impulses can be carried on.
   */
  private static final double DEEPER_M = 1e-4;

  /** Places nearer to each other are one, m. */
  private static final double SAME_M = 2e-3;

  private final double[] places = new double[3 * MAX_CANDIDATES];
  private final double[] normals = new double[3 * MAX_CANDIDATES];
  private final double[] depths = new double[MAX_CANDIDATES];

  /** How far each is from the nearest that is chosen, squared, m^2. */
  private final double[] least2 = new double[MAX_CANDIDATES];

  private final int[] kept = new int[MAX_CHOSEN];
  private int count;

  /** Forgets all. */
  void clear() {
    count = 0;
  }

  /** Whether there is none. */
  boolean empty() {
    return count == 0;
  }

  /** Takes one; of too many the deepest stay. */
  void put(double x, double y, double z, double[] normal3, double sign, double depth) {
    int at = count;
    if (at == MAX_CANDIDATES) {
      at = 0;
      for (int i = 1; i < MAX_CANDIDATES; i++) {
        at = depths[i] < depths[at] ? i : at;
      }
      if (depths[at] >= depth) {
        return;
      }
    } else {
      count++;
    }
    depths[at] = depth;
    places[3 * at] = x;
    places[3 * at + 1] = y;
    places[3 * at + 2] = z;
    for (int axis = 0; axis < 3; axis++) {
      normals[3 * at + axis] = sign * normal3[axis];
    }
  }

  /**
   * The deepest, then those that are farthest from all that are chosen.
   *
   * @param most to be chosen, at most 4
   * @param found overwritten with them
   * @return how many there are
   */
  int choose(int most, DContactGeomBuffer found) {
    int chosen = 0;
    while (chosen < most && chosen < kept.length) {
      int next = chosen == 0 ? deepest() : farthest(chosen);
      if (next < 0) {
        break;
      }
      kept[chosen] = next;
      DContactGeom contact = found.get(chosen++);
      int at = 3 * next;
      contact.pos.set(places[at], places[at + 1], places[at + 2]);
      contact.normal.set(normals[at], normals[at + 1], normals[at + 2]);
      contact.depth = depths[next];
    }
    return chosen;
  }

  private int deepest() {
    int deepest = count == 0 ? -1 : 0;
    for (int i = 1; i < count; i++) {
      deepest = depths[i] > depths[deepest] + DEEPER_M ? i : deepest;
    }
    return deepest;
  }

  /** The one farthest from all that are chosen; the latest of these is looked at first here. */
  private int farthest(int chosen) {
    int farthest = -1;
    double most2 = SAME_M * SAME_M;
    int latest = 3 * kept[chosen - 1];
    for (int i = 0; i < count; i++) {
      double x = places[3 * i] - places[latest];
      double y = places[3 * i + 1] - places[latest + 1];
      double z = places[3 * i + 2] - places[latest + 2];
      double square = x * x + y * y + z * z;
      if (chosen == 1 || square < least2[i]) {
        least2[i] = square;
      }
      if (least2[i] > most2 * (1 + 1e-9)) {
        most2 = least2[i];
        farthest = i;
      }
    }
    return farthest;
  }
}
