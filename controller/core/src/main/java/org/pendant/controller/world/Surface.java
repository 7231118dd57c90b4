package org.pendant.controller.world;

import java.util.List;
import org.pendant.models.mesh.MeshDistance;
import org.pendant.models.pose.Transforms;

/** Surface: the boundary of a solid, prepared for finding how far points are from it. */
sealed interface Surface {

  /** The surface of an object. */
  static Surface of(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane plane -> new Flat(plane);
      case SceneObject.Box box -> new Block(box);
      case SceneObject.Sphere sphere -> new Ball(sphere);
      case SceneObject.Rod rod -> new Bar(rod);
      case SceneObject.Mesh mesh -> new Faces(mesh);
      case SceneObject.Compound compound ->
          new Joined(compound.pieces().stream().map(Surface::of).toList());
    };
  }

  /**
   * The distance of a point of the base frame, m: above 0 outside, below 0 inside.
   *
   * @param normalInBase overwritten with the direction, of length 1, in which the distance grows
   *     fastest
   */
  double distanceM(double x, double y, double z, double[] normalInBase);

  /** The surface of a half space. */
  final class Flat implements Surface {
    private final Vector3 normal;
    private final Vector3 point;

    Flat(SceneObject.Plane plane) {
      normal = plane.normalInBase();
      point = plane.pointInBaseM();
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      normalInBase[0] = normal.x();
      normalInBase[1] = normal.y();
      normalInBase[2] = normal.z();
      return normal.x() * (x - point.x())
          + normal.y() * (y - point.y())
          + normal.z() * (z - point.z());
    }
  }

  /** The surface of a ball. From its centre, every way out is as short; up is taken. */
  final class Ball implements Surface {
    private final Vector3 centre;
    private final double radiusM;

    Ball(SceneObject.Sphere sphere) {
      centre = sphere.centreInBaseM();
      radiusM = sphere.radiusM();
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      double dx = x - centre.x();
      double dy = y - centre.y();
      double dz = z - centre.z();
      double fromCentreM = Math.sqrt(dx * dx + dy * dy + dz * dz);
      boolean atCentre = fromCentreM == 0;
      normalInBase[0] = atCentre ? 0 : dx / fromCentreM;
      normalInBase[1] = atCentre ? 0 : dy / fromCentreM;
      normalInBase[2] = atCentre ? 1 : dz / fromCentreM;
      return fromCentreM - radiusM;
    }
  }

  /**
   * The surface of a block, its edges and corners rounded: a smaller block, the core, and a skin of
   * even thickness around it. In the skin and outside, the normal leads away from the nearest point
   * of the core and so turns steadily from one face to the next. Within the core it is that of the
   * nearest face: it jumps where two faces are equally near, but the distance does not, so a spring
   * of that length gives back what was put into it on every way through.
   */
  final class Block implements Surface {
    /** Thickness of the skin, m, on blocks that are thick enough. */
    private static final double SKIN_M = 1e-3;

    /** Thickness of the skin as a share of the shortest side, on thinner ones. */
    private static final double SKIN_SHARE = 0.25;

    private final double[] inBase = new double[Transforms.SIZE];
    private final Vector3 halfCoreM;
    private final double skinM;

    Block(SceneObject.Box box) {
      Transforms.of(box.poseInBase(), inBase);
      Vector3 size = box.sizeM();
      double shortestM = Math.min(size.x(), Math.min(size.y(), size.z()));
      skinM = Math.min(SKIN_M, SKIN_SHARE * shortestM);
      halfCoreM = new Vector3(size.x() / 2 - skinM, size.y() / 2 - skinM, size.z() / 2 - skinM);
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      double dx = x - inBase[9];
      double dy = y - inBase[10];
      double dz = z - inBase[11];
      double ownX = inBase[0] * dx + inBase[3] * dy + inBase[6] * dz;
      double ownY = inBase[1] * dx + inBase[4] * dy + inBase[7] * dz;
      double ownZ = inBase[2] * dx + inBase[5] * dy + inBase[8] * dz;
      double beyondX = Math.abs(ownX) - halfCoreM.x();
      double beyondY = Math.abs(ownY) - halfCoreM.y();
      double beyondZ = Math.abs(ownZ) - halfCoreM.z();
      double outX = Math.max(beyondX, 0);
      double outY = Math.max(beyondY, 0);
      double outZ = Math.max(beyondZ, 0);
      double fromCoreM = Math.sqrt(outX * outX + outY * outY + outZ * outZ);
      if (fromCoreM > 0) {
        turn(
            Math.copySign(outX / fromCoreM, ownX),
            Math.copySign(outY / fromCoreM, ownY),
            Math.copySign(outZ / fromCoreM, ownZ),
            normalInBase);
        return fromCoreM - skinM;
      }
      if (beyondX >= beyondY && beyondX >= beyondZ) {
        turn(Math.copySign(1, ownX), 0, 0, normalInBase);
        return beyondX - skinM;
      }
      if (beyondY >= beyondZ) {
        turn(0, Math.copySign(1, ownY), 0, normalInBase);
        return beyondY - skinM;
      }
      turn(0, 0, Math.copySign(1, ownZ), normalInBase);
      return beyondZ - skinM;
    }

    private void turn(double x, double y, double z, double[] normalInBase) {
      for (int row = 0; row < 3; row++) {
        normalInBase[row] = inBase[3 * row] * x + inBase[3 * row + 1] * y + inBase[3 * row + 2] * z;
      }
    }
  }

  /**
   * The surface of a round bar. As that of a block it is a core with a skin of even thickness
   * around: the core of a capsule is a line, that of a cylinder a thinner and shorter one. On its
   * axis the way out along x is taken.
   */
  final class Bar implements Surface {
    private final double[] inBase = new double[Transforms.SIZE];
    private final double coreM;
    private final double halfCoreM;
    private final double skinM;

    Bar(SceneObject.Rod rod) {
      Transforms.of(rod.poseInBase(), inBase);
      double thinnestM = Math.min(2 * rod.radiusM(), rod.lengthM());
      skinM = rod.capsule() ? rod.radiusM() : Math.min(Block.SKIN_M, Block.SKIN_SHARE * thinnestM);
      coreM = rod.radiusM() - skinM;
      halfCoreM = rod.lengthM() / 2 - (rod.capsule() ? 0 : skinM);
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      double dx = x - inBase[9];
      double dy = y - inBase[10];
      double dz = z - inBase[11];
      double ownX = inBase[0] * dx + inBase[3] * dy + inBase[6] * dz;
      double ownY = inBase[1] * dx + inBase[4] * dy + inBase[7] * dz;
      double ownZ = inBase[2] * dx + inBase[5] * dy + inBase[8] * dz;
      double fromAxisM = Math.sqrt(ownX * ownX + ownY * ownY);
      double alongX = fromAxisM > 0 ? ownX / fromAxisM : 1;
      double alongY = fromAxisM > 0 ? ownY / fromAxisM : 0;
      double beyondR = fromAxisM - coreM;
      double beyondZ = Math.abs(ownZ) - halfCoreM;
      double outR = Math.max(beyondR, 0);
      double outZ = Math.max(beyondZ, 0);
      double fromCoreM = Math.sqrt(outR * outR + outZ * outZ);
      double shareR = beyondR >= beyondZ ? 1 : 0;
      double shareZ = 1 - shareR;
      if (fromCoreM > 0) {
        shareR = outR / fromCoreM;
        shareZ = outZ / fromCoreM;
      }
      double nx = shareR * alongX;
      double ny = shareR * alongY;
      double nz = Math.copySign(shareZ, ownZ);
      for (int row = 0; row < 3; row++) {
        normalInBase[row] =
            inBase[3 * row] * nx + inBase[3 * row + 1] * ny + inBase[3 * row + 2] * nz;
      }
      return (fromCoreM > 0 ? fromCoreM : Math.max(beyondR, beyondZ)) - skinM;
    }
  }

  /**
   * The surface of several solids together: that of the nearest, or in which a point is deepest.
   */
  final class Joined implements Surface {
    private final List<Surface> pieces;
    private final double[] normal = new double[3];

    Joined(List<Surface> pieces) {
      this.pieces = pieces;
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < pieces.size(); i++) {
        double distanceM = pieces.get(i).distanceM(x, y, z, normal);
        if (distanceM < least) {
          least = distanceM;
          System.arraycopy(normal, 0, normalInBase, 0, 3);
        }
      }
      return least;
    }
  }

  /** The surface of a mesh, with sharp edges. */
  final class Faces implements Surface {
    private final double[] inBase = new double[Transforms.SIZE];
    private final double[] ownNormal = new double[3];
    private final MeshDistance distance;

    Faces(SceneObject.Mesh mesh) {
      Transforms.of(mesh.poseInBase(), inBase);
      distance = new MeshDistance(mesh.part().triangles());
    }

    @Override
    public double distanceM(double x, double y, double z, double[] normalInBase) {
      double dx = x - inBase[9];
      double dy = y - inBase[10];
      double dz = z - inBase[11];
      double awayM =
          distance.toPoint(
              inBase[0] * dx + inBase[3] * dy + inBase[6] * dz,
              inBase[1] * dx + inBase[4] * dy + inBase[7] * dz,
              inBase[2] * dx + inBase[5] * dy + inBase[8] * dz,
              ownNormal);
      for (int row = 0; row < 3; row++) {
        normalInBase[row] =
            inBase[3 * row] * ownNormal[0]
                + inBase[3 * row + 1] * ownNormal[1]
                + inBase[3 * row + 2] * ownNormal[2];
      }
      return awayM;
    }
  }
}
