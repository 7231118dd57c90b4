package org.pendant.cell;

import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;

/**
 * Contact manifold: the places at which two shapes that touch along a normal hold each other. These
 * are the corners of what the faces or edges that meet there have in common, at most four of them.
 */
final class ContactManifold {
  private static final int MAX_PLACES = 4;

  /** Corners of two polygons, or of one and a circle. */
  private static final int MAX_CORNERS = 24;

  /** Edges are parallel whose directions differ by less, rad. */
  private static final double PARALLEL = 0.05;

  /** A place counts as the deepest unless a later one is so much deeper, m. */
  private static final double DEEPER_M = 1e-5;

  /**
   * A disc tips over its deepest place if that is so much deeper than its middle, m. With less it
   * stands on places that stay where they are, whose impulses can be carried on.
   */
  private static final double LEAN_M = 5e-5;

  /** Middles of discs are one if they are so near, m. */
  private static final double SAME_MIDDLE_M = 1e-4;

  final ContactFrame frame = new ContactFrame();
  private final ContactFeature upper = new ContactFeature();
  private final ContactFeature lower = new ContactFeature();
  private double[] x = new double[MAX_CORNERS];
  private double[] y = new double[MAX_CORNERS];
  private double[] clippedX = new double[MAX_CORNERS];
  private double[] clippedY = new double[MAX_CORNERS];
  private final double[] depth = new double[MAX_CORNERS];
  private final int[] kept = new int[MAX_PLACES];
  private int corners;
  private int keptCount;

  /** How deep the deepest place is, m. */
  private double deepestM;

  /**
   * Finds what two shapes have in common along the normal of {@link #frame}, which leads from the
   * second to the first.
   *
   * @param second null for a half space
   */
  void find(ConvexShape first, double[] pose1, ConvexShape second, double[] pose2) {
    upper.set(first, pose1, frame, -1);
    lower.set(second, pose2, frame, 1);
    corners = 0;
    meet();
    int within = 0;
    deepestM = 0;
    for (int i = 0; i < corners; i++) {
      double here = lower.heightAt(x[i], y[i]) - upper.heightAt(x[i], y[i]);
      if (here > 0) {
        x[within] = x[i];
        y[within] = y[i];
        depth[within++] = here;
        deepestM = Math.max(deepestM, here);
      }
    }
    corners = within;
    choose();
  }

  /** How deep the deepest place is, m; 0 where there is none. */
  double deepestM() {
    return deepestM;
  }

  /**
   * Tells the places.
   *
   * @param overlapM how deep the shapes are in one another; where they have no place in common, one
   *     of that depth is told between them
   */
  int tell(DContactGeomBuffer found, double overlapM) {
    if (keptCount == 0) {
      ContactFeature of = upper.count <= lower.count ? upper : lower;
      double atX = 0;
      double atY = 0;
      for (int i = 0; i < of.count; i++) {
        atX += of.x[i] / of.count;
        atY += of.y[i] / of.count;
      }
      put(found.get(0), atX, atY, upper.heightAt(atX, atY), overlapM);
      return 1;
    }
    for (int i = 0; i < keptCount; i++) {
      int corner = kept[i];
      put(
          found.get(i),
          x[corner],
          y[corner],
          upper.heightAt(x[corner], y[corner]) + depth[corner] / 2,
          depth[corner]);
    }
    return keptCount;
  }

  private void put(DContactGeom contact, double atX, double atY, double atZ, double depthM) {
    double[] o = frame.origin;
    double[] a = frame.tangent1;
    double[] b = frame.tangent2;
    double[] n = frame.normal;
    contact.pos.set(
        o[0] + atX * a[0] + atY * b[0] + atZ * n[0],
        o[1] + atX * a[1] + atY * b[1] + atZ * n[1],
        o[2] + atX * a[2] + atY * b[2] + atZ * n[2]);
    contact.normal.set(n[0], n[1], n[2]);
    contact.depth = depthM;
  }

  private void meet() {
    switch (upper.kind) {
      case POINT -> point(upper, lower);
      case EDGE -> {
        switch (lower.kind) {
          case POINT -> point(lower, upper);
          case EDGE -> edges();
          case POLYGON, DISC, PLANE -> edgeIn(upper, lower);
        }
      }
      case POLYGON -> {
        switch (lower.kind) {
          case POINT -> point(lower, upper);
          case EDGE -> edgeIn(lower, upper);
          case POLYGON -> polygons();
          case DISC -> discAndPolygon(lower, upper);
          case PLANE -> all(upper);
        }
      }
      case DISC -> {
        switch (lower.kind) {
          case POINT -> point(lower, upper);
          case EDGE -> edgeIn(lower, upper);
          case POLYGON -> discAndPolygon(upper, lower);
          case DISC -> discs();
          case PLANE -> rim(upper);
        }
      }
      case PLANE -> {
        // a half space never lies on anything
      }
    }
  }

  private void add(double atX, double atY) {
    x[corners] = atX;
    y[corners++] = atY;
  }

  private void all(ContactFeature of) {
    for (int i = 0; i < of.count; i++) {
      add(of.x[i], of.y[i]);
    }
  }

  private void point(ContactFeature of, ContactFeature in) {
    if (in.kind == ContactFeature.Kind.POINT
        || in.kind == ContactFeature.Kind.EDGE
        || within(in, of.x[0], of.y[0])) {
      add(of.x[0], of.y[0]);
    }
  }

  private static boolean within(ContactFeature face, double atX, double atY) {
    return switch (face.kind) {
      case POLYGON -> {
        boolean in = true;
        for (int i = 0; in && i < 4; i++) {
          in = side(face, i, atX, atY) >= 0;
        }
        yield in;
      }
      case DISC -> {
        double dx = atX - face.x[0];
        double dy = atY - face.y[0];
        yield dx * dx + dy * dy <= face.radiusM * face.radiusM;
      }
      case POINT, EDGE, PLANE -> true;
    };
  }

  /** On which side of an edge of a polygon a place is: positive inside. */
  private static double side(ContactFeature face, int edge, double atX, double atY) {
    int next = edge + 1 & 3;
    int opposite = edge + 2 & 3;
    double alongX = face.x[next] - face.x[edge];
    double alongY = face.y[next] - face.y[edge];
    double side = alongX * (atY - face.y[edge]) - alongY * (atX - face.x[edge]);
    double inner =
        alongX * (face.y[opposite] - face.y[edge]) - alongY * (face.x[opposite] - face.x[edge]);
    return inner < 0 ? -side : side;
  }

  private void edges() {
    double ux = upper.x[1] - upper.x[0];
    double uy = upper.y[1] - upper.y[0];
    double vx = lower.x[1] - lower.x[0];
    double vy = lower.y[1] - lower.y[0];
    double dx = lower.x[0] - upper.x[0];
    double dy = lower.y[0] - upper.y[0];
    double cross = ux * vy - uy * vx;
    double uu = ux * ux + uy * uy;
    if (cross * cross > PARALLEL * PARALLEL * uu * (vx * vx + vy * vy)) {
      double share = Math.max(0, Math.min(1, (dx * vy - dy * vx) / cross));
      add(upper.x[0] + share * ux, upper.y[0] + share * uy);
      return;
    }
    if (uu == 0) {
      add(upper.x[0], upper.y[0]);
      return;
    }
    double one = (dx * ux + dy * uy) / uu;
    double other = one + (vx * ux + vy * uy) / uu;
    double from = Math.max(0, Math.min(one, other));
    double to = Math.min(1, Math.max(one, other));
    if (from <= to) {
      add(upper.x[0] + from * ux, upper.y[0] + from * uy);
      add(upper.x[0] + to * ux, upper.y[0] + to * uy);
    }
  }

  /** The part of an edge that is over or under a face. */
  private void edgeIn(ContactFeature edge, ContactFeature face) {
    double ux = edge.x[1] - edge.x[0];
    double uy = edge.y[1] - edge.y[0];
    double from = 0;
    double to = 1;
    if (face.kind == ContactFeature.Kind.POLYGON) {
      for (int i = 0; i < 4; i++) {
        double begin = side(face, i, edge.x[0], edge.y[0]);
        double end = side(face, i, edge.x[1], edge.y[1]);
        if (begin < 0 && end < 0) {
          return;
        }
        if (begin < 0) {
          from = Math.max(from, begin / (begin - end));
        } else if (end < 0) {
          to = Math.min(to, begin / (begin - end));
        }
      }
    } else if (face.kind == ContactFeature.Kind.DISC) {
      double dx = edge.x[0] - face.x[0];
      double dy = edge.y[0] - face.y[0];
      double a = ux * ux + uy * uy;
      double b = dx * ux + dy * uy;
      double root = b * b - a * (dx * dx + dy * dy - face.radiusM * face.radiusM);
      if (root < 0 || a == 0) {
        return;
      }
      from = Math.max(0, (-b - Math.sqrt(root)) / a);
      to = Math.min(1, (-b + Math.sqrt(root)) / a);
    }
    if (from <= to) {
      add(edge.x[0] + from * ux, edge.y[0] + from * uy);
      add(edge.x[0] + to * ux, edge.y[0] + to * uy);
    }
  }

  /** Cuts one polygon by the edges of the other, one after the other. */
  private void polygons() {
    all(upper);
    for (int edge = 0; edge < 4 && corners > 0; edge++) {
      int count = 0;
      double before = side(lower, edge, x[corners - 1], y[corners - 1]);
      for (int i = 0; i < corners; i++) {
        int previous = i == 0 ? corners - 1 : i - 1;
        double here = side(lower, edge, x[i], y[i]);
        if (before < 0 != here < 0) {
          double share = before / (before - here);
          clippedX[count] = x[previous] + share * (x[i] - x[previous]);
          clippedY[count++] = y[previous] + share * (y[i] - y[previous]);
        }
        if (here >= 0) {
          clippedX[count] = x[i];
          clippedY[count++] = y[i];
        }
        before = here;
      }
      corners = count;
      double[] swap = x;
      x = clippedX;
      clippedX = swap;
      swap = y;
      y = clippedY;
      clippedY = swap;
    }
  }

  /** Four places of a rim, the deepest one among them. */
  private void rim(ContactFeature disc) {
    double gx = lower.slopeX - upper.slopeX;
    double gy = lower.slopeY - upper.slopeY;
    double steep = Math.sqrt(gx * gx + gy * gy);
    boolean leans = steep * disc.radiusM > LEAN_M;
    double c = disc.radiusM * (leans ? gx / steep : 1);
    double s = disc.radiusM * (leans ? gy / steep : 0);
    add(disc.x[0] + c, disc.y[0] + s);
    add(disc.x[0] - s, disc.y[0] + c);
    add(disc.x[0] - c, disc.y[0] - s);
    add(disc.x[0] + s, disc.y[0] - c);
  }

  private void discAndPolygon(ContactFeature disc, ContactFeature polygon) {
    rim(disc);
    int within = 0;
    for (int i = 0; i < 4; i++) {
      if (within(polygon, x[i], y[i])) {
        x[within] = x[i];
        y[within++] = y[i];
      }
    }
    corners = within;
    if (within == 4) {
      return;
    }
    for (int i = 0; i < 4; i++) {
      int next = i + 1 & 3;
      double dx = polygon.x[i] - disc.x[0];
      double dy = polygon.y[i] - disc.y[0];
      double ux = polygon.x[next] - polygon.x[i];
      double uy = polygon.y[next] - polygon.y[i];
      double a = ux * ux + uy * uy;
      double b = dx * ux + dy * uy;
      double c = dx * dx + dy * dy - disc.radiusM * disc.radiusM;
      if (c <= 0) {
        add(polygon.x[i], polygon.y[i]);
      }
      double root = b * b - a * c;
      if (root > 0) {
        double one = (-b - Math.sqrt(root)) / a;
        double other = (-b + Math.sqrt(root)) / a;
        if (one > 0 && one < 1) {
          add(polygon.x[i] + one * ux, polygon.y[i] + one * uy);
        }
        if (other > 0 && other < 1) {
          add(polygon.x[i] + other * ux, polygon.y[i] + other * uy);
        }
      }
    }
  }

  private void discs() {
    double dx = lower.x[0] - upper.x[0];
    double dy = lower.y[0] - upper.y[0];
    double away = Math.sqrt(dx * dx + dy * dy);
    double r1 = upper.radiusM;
    double r2 = lower.radiusM;
    if (away >= r1 + r2) {
      return;
    }
    if (away <= Math.max(Math.abs(r1 - r2), SAME_MIDDLE_M)) {
      rim(r1 <= r2 ? upper : lower);
      return;
    }
    double ux = dx / away;
    double uy = dy / away;
    double along = (away * away + r1 * r1 - r2 * r2) / (2 * away);
    double across = Math.sqrt(Math.max(0, r1 * r1 - along * along));
    add(upper.x[0] + r1 * ux, upper.y[0] + r1 * uy);
    add(upper.x[0] + along * ux - across * uy, upper.y[0] + along * uy + across * ux);
    add(lower.x[0] - r2 * ux, lower.y[0] - r2 * uy);
    add(upper.x[0] + along * ux + across * uy, upper.y[0] + along * uy - across * ux);
  }

  /** The deepest place, the one farthest from it, and the outermost on both sides of these. */
  private void choose() {
    keptCount = 0;
    if (corners <= MAX_PLACES) {
      for (int i = 0; i < corners; i++) {
        kept[keptCount++] = i;
      }
      return;
    }
    int deepest = 0;
    for (int i = 1; i < corners; i++) {
      deepest = depth[i] > depth[deepest] + DEEPER_M ? i : deepest;
    }
    int farthest = 0;
    double most = -1;
    for (int i = 0; i < corners; i++) {
      double square =
          (x[i] - x[deepest]) * (x[i] - x[deepest]) + (y[i] - y[deepest]) * (y[i] - y[deepest]);
      if (square > most) {
        most = square;
        farthest = i;
      }
    }
    int left = -1;
    int right = -1;
    double mostLeft = 0;
    double mostRight = 0;
    for (int i = 0; i < corners; i++) {
      double side =
          (x[farthest] - x[deepest]) * (y[i] - y[deepest])
              - (y[farthest] - y[deepest]) * (x[i] - x[deepest]);
      if (side > mostLeft) {
        mostLeft = side;
        left = i;
      } else if (side < mostRight) {
        mostRight = side;
        right = i;
      }
    }
    kept[keptCount++] = deepest;
    kept[keptCount++] = farthest;
    if (left >= 0) {
      kept[keptCount++] = left;
    }
    if (right >= 0) {
      kept[keptCount++] = right;
    }
  }
}
