package org.pendant.cell;

import org.pendant.models.mesh.ConvexHull;

/** Hull probe: a part of space, as hulls are looked for in it. */
interface HullProbe {
  /** The thinnest box, m. */
  double MIN_THICK_M = 1e-6;

  /** Whether some of a solid is in it now. */
  boolean holds(Polyhedron solid);

  /** A ball that is swept along a line. */
  static HullProbe line(double[] from3, double[] to3, double radiusM) {
    SegmentInHull line = new SegmentInHull();
    line.set(from3, to3);
    double[] unused = new double[3];
    return solid -> line.nearest(solid, unused) < radiusM;
  }

  /** A box along the axes of the base. */
  static HullProbe block(double[] min3, double[] max3) {
    double[] pose = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    double[] size = new double[3];
    for (int k = 0; k < 3; k++) {
      pose[9 + k] = (min3[k] + max3[k]) / 2;
      size[k] = Math.max(MIN_THICK_M, max3[k] - min3[k]);
    }
    Polyhedron block = new Polyhedron(ConvexHull.block(size[0], size[1], size[2]), pose);
    HullContacts contacts = new HullContacts();
    return solid -> contacts.overlap(block, solid);
  }
}
