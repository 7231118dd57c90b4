package org.pendant.models.mesh;

import java.util.HashMap;
import java.util.Map;

/** Open edges: those of triangles that have none on the other side, in the other direction. */
final class OpenEdges {
  private final int[] corners;

  /** For each edge, how many triangles go along it in one direction more than in the other. */
  private final Map<Long, Integer> more = new HashMap<>();

  /** The edges of triangles, three numbers of points each. */
  OpenEdges(int[] corners) {
    this.corners = corners;
    for (int i = 0; i < corners.length; i++) {
      more.merge(edge(i), from(i) < to(i) ? 1 : -1, Integer::sum);
    }
  }

  /** How many there are. */
  long count() {
    return more.values().stream().filter(each -> each != 0).count();
  }

  /** The points of the first one in the order of triangles, which must be there. */
  int[] first() {
    for (int i = 0; i < corners.length; i++) {
      if (more.get(edge(i)) != 0) {
        return new int[] {from(i), to(i)};
      }
    }
    throw new IllegalStateException("no edge is open");
  }

  private int from(int side) {
    return corners[side];
  }

  private int to(int side) {
    return corners[side % 3 == 2 ? side - 2 : side + 1];
  }

  private long edge(int side) {
    return ((long) Math.min(from(side), to(side)) << 32) | Math.max(from(side), to(side));
  }
}
