package org.pendant.desktop.scene;

import java.util.Optional;
import org.joml.Intersectionf;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.ArmMeshes;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.desktop.scene.mesh.Mesh;
import org.pendant.models.pose.Pose;

/** Pick: finds what a ray from the eye meets first. */
public final class Pick {
  /**
   * A ray that passes the tool centre point as close as this means it, m for each m of distance.
   */
  private static final double TCP_SHARE = 0.012;

  /** Farther than this from the middle planes have faded, as a share of the arm's reach. */
  private static final double PLANE_SHARE = 1.6;

  private static final float EPSILON = 1e-9f;

  private Pick() {}

  /**
   * What a ray meets. The tool centre point comes first wherever the ray passes close to it: its
   * frame is seen through the flange, and the flange is where people grab.
   *
   * @param ray from {@link Camera#ray}
   * @param meshes of the model's arm
   */
  public static Optional<Picked> at(Ray ray, SceneModel model, ArmMeshes meshes) {
    Optional<Picked> tcp = tcp(ray, model.tcpInBase());
    if (tcp.isPresent()) {
      return tcp;
    }
    Optional<Picked> link = link(ray, model, meshes);
    Optional<Picked> object = ObjectHit.nearest(ray, model, PLANE_SHARE * model.arm().reachM());
    double linkM = link.map(Picked::distanceM).orElse(Double.POSITIVE_INFINITY);
    return object.filter(hit -> hit.distanceM() < linkM).or(() -> link);
  }

  private static Optional<Picked> tcp(Ray ray, Pose tcpInBase) {
    double x = tcpInBase.x() - ray.fromM().x();
    double y = tcpInBase.y() - ray.fromM().y();
    double z = tcpInBase.z() - ray.fromM().z();
    Vector3 d = ray.direction();
    double along = x * d.x() + y * d.y() + z * d.z();
    double across = Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along));
    if (along <= 0 || across > TCP_SHARE * along) {
      return Optional.empty();
    }
    return Optional.of(
        new Picked.OnTcp(new Vector3(tcpInBase.x(), tcpInBase.y(), tcpInBase.z()), along));
  }

  private static Optional<Picked> link(Ray ray, SceneModel model, ArmMeshes meshes) {
    LinkPlaces places = new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad());
    Optional<Picked> nearest = Optional.empty();
    double nearestM = Double.POSITIVE_INFINITY;
    for (Link link : Link.values()) {
      Matrix4f toLink = places.of(link).invert(new Matrix4f());
      Vector3f from = toLink.transformPosition(vector(ray.fromM()));
      Vector3f direction = toLink.transformDirection(vector(ray.direction()));
      double distanceM = distanceM(meshes.of(link), from, direction);
      if (distanceM < nearestM) {
        nearestM = distanceM;
        nearest = Optional.of(new Picked.OnLink(link, ray.pointM(distanceM), distanceM));
      }
    }
    return nearest;
  }

  /** How far a ray goes until it meets a mesh, m; infinite if it does not. */
  private static double distanceM(Mesh mesh, Vector3f from, Vector3f direction) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int t = 0; t < mesh.triangleCount(); t++) {
      float distance =
          Intersectionf.intersectRayTriangleFront(
              from,
              direction,
              mesh.position(mesh.corner(t, 0)),
              mesh.position(mesh.corner(t, 1)),
              mesh.position(mesh.corner(t, 2)),
              EPSILON);
      if (distance >= 0 && distance < nearest) {
        nearest = distance;
      }
    }
    return nearest;
  }

  private static Vector3f vector(Vector3 v) {
    return new Vector3f((float) v.x(), (float) v.y(), (float) v.z());
  }
}
