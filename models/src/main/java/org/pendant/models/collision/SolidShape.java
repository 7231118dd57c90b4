package org.pendant.models.collision;

import org.pendant.models.mesh.MeshDistance;
import org.pendant.models.mesh.MeshLine;
import org.pendant.models.mesh.SegmentDistance;
import org.pendant.models.mesh.TriangleMesh;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Solid shape: a solid that stands around an arm; for one thread at a time. All lengths in m, in
 * the base frame.
 */
public sealed interface SolidShape {
  /** How far a point is from it: below 0 by the depth inside. */
  double toPoint(double x, double y, double z);

  /**
   * How far a line from one point to another is from it: of the deepest point, where it goes
   * inside.
   */
  double toSegment(double ax, double ay, double az, double bx, double by, double bz);

  /** The lines along which it meets solids; none of one that is flat or made of triangles. */
  default SolidEdges edges() {
    return SolidEdges.NONE;
  }

  /** All that is on the far side of a plane from where its normal points. */
  final class HalfSpace implements SolidShape {
    private final double nx;
    private final double ny;
    private final double nz;
    private final double height;

    /**
     * A half space.
     *
     * @param px a point of the plane, along x
     * @param nx the normal along x; of length 1 with the others
     */
    public HalfSpace(double px, double py, double pz, double nx, double ny, double nz) {
      this.nx = nx;
      this.ny = ny;
      this.nz = nz;
      height = nx * px + ny * py + nz * pz;
    }

    @Override
    public double toPoint(double x, double y, double z) {
      return nx * x + ny * y + nz * z - height;
    }

    @Override
    public double toSegment(double ax, double ay, double az, double bx, double by, double bz) {
      return Math.min(toPoint(ax, ay, az), toPoint(bx, by, bz));
    }
  }

  /** A ball. */
  final class Ball implements SolidShape {
    private final double cx;
    private final double cy;
    private final double cz;
    private final double radius;
    private final SolidEdges edges;

    /** A ball around a centre. */
    public Ball(double cx, double cy, double cz, double radius) {
      edges = SolidEdges.axis(new Pose(cx, cy, cz, 0, 0, 0), 0, radius);
      this.cx = cx;
      this.cy = cy;
      this.cz = cz;
      this.radius = radius;
    }

    @Override
    public SolidEdges edges() {
      return edges;
    }

    @Override
    public double toPoint(double x, double y, double z) {
      double dx = x - cx;
      double dy = y - cy;
      double dz = z - cz;
      return Math.sqrt(dx * dx + dy * dy + dz * dz) - radius;
    }

    @Override
    public double toSegment(double ax, double ay, double az, double bx, double by, double bz) {
      return SegmentDistance.toPoint(ax, ay, az, bx, by, bz, cx, cy, cz) - radius;
    }
  }

  /** A solid at any angle, whose surface is known along its own axes. */
  abstract sealed class Posed implements SolidShape {
    /** What a step of the search leaves of the part of the line where the nearest point may be. */
    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    /** How near the nearest point of a line is found, m. */
    private static final double ACCURACY_M = 1e-7;

    private final double[] inBase = new double[Transforms.SIZE];

    private Posed(Pose inBase) {
      Transforms.of(inBase, this.inBase);
    }

    /** As {@link #toPoint}, along its own axes. */
    abstract double ownToPoint(double x, double y, double z);

    @Override
    public double toPoint(double x, double y, double z) {
      return ownToPoint(own(0, x, y, z), own(1, x, y, z), own(2, x, y, z));
    }

    /**
     * The depth of a point, taken negative, is a convex function of the place, so it has one least
     * value along a line; golden section finds it.
     */
    @Override
    public double toSegment(double ax, double ay, double az, double bx, double by, double bz) {
      double x = own(0, ax, ay, az);
      double y = own(1, ax, ay, az);
      double z = own(2, ax, ay, az);
      double dx = own(0, bx, by, bz) - x;
      double dy = own(1, bx, by, bz) - y;
      double dz = own(2, bx, by, bz) - z;
      double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
      double from = 0;
      double to = 1;
      double left = 1 - GOLDEN;
      double right = GOLDEN;
      double atLeft = ownToPoint(x + left * dx, y + left * dy, z + left * dz);
      double atRight = ownToPoint(x + right * dx, y + right * dy, z + right * dz);
      while ((to - from) * length > ACCURACY_M) {
        if (atLeft <= atRight) {
          to = right;
          right = left;
          atRight = atLeft;
          left = to - GOLDEN * (to - from);
          atLeft = ownToPoint(x + left * dx, y + left * dy, z + left * dz);
        } else {
          from = left;
          left = right;
          atLeft = atRight;
          right = from + GOLDEN * (to - from);
          atRight = ownToPoint(x + right * dx, y + right * dy, z + right * dz);
        }
      }
      // the search comes near the ends, and never to them
      double atEnds = Math.min(ownToPoint(x, y, z), ownToPoint(x + dx, y + dy, z + dz));
      return Math.min(atEnds, Math.min(atLeft, atRight));
    }

    final double own(int axis, double x, double y, double z) {
      return inBase[axis] * (x - inBase[9])
          + inBase[3 + axis] * (y - inBase[10])
          + inBase[6 + axis] * (z - inBase[11]);
    }
  }

  /** A block, at any angle. */
  final class Block extends Posed {
    private final double halfX;
    private final double halfY;
    private final double halfZ;
    private final SolidEdges edges;

    /** A block around the origin of a pose, with the lengths of its sides. */
    public Block(Pose inBase, double sizeX, double sizeY, double sizeZ) {
      super(inBase);
      edges = SolidEdges.block(inBase, sizeX, sizeY, sizeZ);
      halfX = sizeX / 2;
      halfY = sizeY / 2;
      halfZ = sizeZ / 2;
    }

    @Override
    public SolidEdges edges() {
      return edges;
    }

    @Override
    double ownToPoint(double x, double y, double z) {
      double beyondX = Math.abs(x) - halfX;
      double beyondY = Math.abs(y) - halfY;
      double beyondZ = Math.abs(z) - halfZ;
      double most = Math.max(beyondX, Math.max(beyondY, beyondZ));
      if (most <= 0) {
        return most;
      }
      double outX = Math.max(beyondX, 0);
      double outY = Math.max(beyondY, 0);
      double outZ = Math.max(beyondZ, 0);
      return Math.sqrt(outX * outX + outY * outY + outZ * outZ);
    }
  }

  /** A round bar along the z of its pose, at any angle. */
  final class Rod extends Posed {
    private final double radius;
    private final double half;
    private final boolean capsule;
    private final SolidEdges edges;

    /** A bar around the origin of a pose; the half balls at the ends of a capsule come on top. */
    public Rod(Pose inBase, double radius, double length, boolean capsule) {
      super(inBase);
      edges =
          capsule
              ? SolidEdges.axis(inBase, length, radius)
              : SolidEdges.cylinder(inBase, radius, length);
      this.radius = radius;
      half = length / 2;
      this.capsule = capsule;
    }

    @Override
    public SolidEdges edges() {
      return edges;
    }

    @Override
    double ownToPoint(double x, double y, double z) {
      double fromAxis = Math.sqrt(x * x + y * y);
      double beyondZ = Math.abs(z) - half;
      double outZ = Math.max(beyondZ, 0);
      if (capsule) {
        return Math.sqrt(fromAxis * fromAxis + outZ * outZ) - radius;
      }
      double beyondR = fromAxis - radius;
      double outR = Math.max(beyondR, 0);
      return beyondR <= 0 && beyondZ <= 0
          ? Math.max(beyondR, beyondZ)
          : Math.sqrt(outR * outR + outZ * outZ);
    }
  }

  /** A solid made of triangles, at any angle. */
  final class Faces extends Posed {
    private final MeshDistance distance;
    private final MeshLine line;
    private final double[] unused = new double[3];

    /** The solid of a mesh whose origin is at a pose. */
    public Faces(Pose inBase, TriangleMesh mesh) {
      super(inBase);
      distance = new MeshDistance(mesh);
      line = new MeshLine(mesh);
    }

    @Override
    double ownToPoint(double x, double y, double z) {
      return distance.toPoint(x, y, z, unused);
    }

    @Override
    public double toSegment(double ax, double ay, double az, double bx, double by, double bz) {
      return line.apartM(
          own(0, ax, ay, az),
          own(1, ax, ay, az),
          own(2, ax, ay, az),
          own(0, bx, by, bz),
          own(1, bx, by, bz),
          own(2, bx, by, bz));
    }
  }
}
