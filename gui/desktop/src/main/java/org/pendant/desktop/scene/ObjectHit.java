package org.pendant.desktop.scene;

import java.util.Optional;
import org.joml.Intersectiond;
import org.joml.Matrix4d;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.mesh.MeshLine;
import org.pendant.models.pose.Pose;

/** Object hit: where a ray meets what stands around the arm. */
final class ObjectHit {
  private static final double EPSILON = 1e-12;

  private ObjectHit() {}

  /**
   * The nearest object that a ray meets.
   *
   * @param planeReachM planes are drawn up to this far from the middle, and met only there, m
   */
  static Optional<Picked> nearest(Ray ray, SceneModel model, double planeReachM) {
    Optional<Picked> nearest = Optional.empty();
    double nearestM = Double.POSITIVE_INFINITY;
    for (SceneObject object : model.world().objects()) {
      double distanceM = distanceM(ray, object, planeReachM);
      if (distanceM < nearestM) {
        nearestM = distanceM;
        nearest = Optional.of(new Picked.OnObject(object.name(), ray.pointM(distanceM), distanceM));
      }
    }
    return nearest;
  }

  /** How far a ray goes until it meets an object, m; infinite if it does not. */
  private static double distanceM(Ray ray, SceneObject object, double planeReachM) {
    Vector3d from = vector(ray.fromM());
    Vector3d along = vector(ray.direction());
    return switch (object) {
      case SceneObject.Plane plane -> {
        Vector3d point = vector(plane.pointInBaseM());
        Vector3d normal = vector(plane.normalInBase());
        double distance =
            Math.max(
                Intersectiond.intersectRayPlane(from, along, point, normal, EPSILON),
                Intersectiond.intersectRayPlane(from, along, point, normal.negate(), EPSILON));
        yield distance >= 0 && new Vector3d(from).fma(distance, along).length() < planeReachM
            ? distance
            : Double.POSITIVE_INFINITY;
      }
      case SceneObject.Sphere sphere -> {
        Vector2d hits = new Vector2d();
        double squareM2 = sphere.radiusM() * sphere.radiusM();
        yield Intersectiond.intersectRaySphere(
                from, along, vector(sphere.centreInBaseM()), squareM2, hits)
            ? hits.x
            : Double.POSITIVE_INFINITY;
      }
      case SceneObject.Rod rod -> {
        Matrix4d toRod = frame(rod.poseInBase()).invert();
        toRod.transformPosition(from);
        toRod.transformDirection(along);
        yield rodDistanceM(from, along, rod);
      }
      case SceneObject.Compound compound ->
          compound.pieces().stream()
              .mapToDouble(piece -> distanceM(ray, piece, planeReachM))
              .min()
              .orElse(Double.POSITIVE_INFINITY);
      case SceneObject.Mesh mesh -> {
        Matrix4d toMesh = frame(mesh.poseInBase()).invert();
        toMesh.transformPosition(from);
        toMesh.transformDirection(along);
        yield new MeshLine(mesh.part().triangles())
            .meets(new double[] {from.x, from.y, from.z}, new double[] {along.x, along.y, along.z});
      }
      case SceneObject.Box box -> {
        Matrix4d toBox = frame(box.poseInBase()).invert();
        toBox.transformPosition(from);
        toBox.transformDirection(along);
        Vector3d half = vector(box.sizeM()).mul(0.5);
        Vector2d hits = new Vector2d();
        yield Intersectiond.intersectRayAab(from, along, new Vector3d(half).negate(), half, hits)
            ? hits.x
            : Double.POSITIVE_INFINITY;
      }
    };
  }

  /** Of a rod at the origin along z: its mantle, and discs or balls at its ends. */
  private static double rodDistanceM(Vector3d from, Vector3d along, SceneObject.Rod rod) {
    double half = rod.lengthM() / 2;
    double r = rod.radiusM();
    double nearest = Double.POSITIVE_INFINITY;
    double a = along.x * along.x + along.y * along.y;
    double b = from.x * along.x + from.y * along.y;
    double root = b * b - a * (from.x * from.x + from.y * from.y - r * r);
    if (a > 0 && root >= 0) {
      double t = (-b - Math.sqrt(root)) / a;
      if (t >= 0 && Math.abs(from.z + t * along.z) <= half) {
        nearest = t;
      }
    }
    for (int end = -1; end <= 1; end += 2) {
      Vector2d hits = new Vector2d();
      if (rod.capsule()
          && Intersectiond.intersectRaySphere(
              from, along, new Vector3d(0, 0, end * half), r * r, hits)) {
        nearest = Math.min(nearest, hits.x);
      }
      double t = (end * half - from.z) / along.z;
      if (!rod.capsule() && t >= 0 && Math.hypot(from.x + t * along.x, from.y + t * along.y) <= r) {
        nearest = Math.min(nearest, t);
      }
    }
    return nearest;
  }

  private static Matrix4d frame(Pose pose) {
    return new Matrix4d(LinkPlaces.matrix(pose));
  }

  private static Vector3d vector(Vector3 v) {
    return new Vector3d(v.x(), v.y(), v.z());
  }
}
