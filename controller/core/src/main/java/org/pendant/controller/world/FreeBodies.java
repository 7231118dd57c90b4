package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Free bodies: the objects of a scene that have a mass, as they move among the others. The tool
 * points are balls that push them, and feel them.
 */
final class FreeBodies {
  /** A tool point without a radius is a ball of this one to them, m. */
  private static final double MIN_POINT_M = 0.002;

  private final RigidBodyWorld bodies;
  private final List<SceneObject> objects;
  private final List<ToolPoint> points;

  /** Force and torque on the flange's origin, along the base's axes, in the latest step. */
  private final double[] felt6 = new double[6];

  private final double[] ball12 = new double[Transforms.SIZE];
  private final double[] ballTwist6 = new double[6];
  private final double[] ballWrench6 = new double[6];

  /**
   * The bodies of a scene.
   *
   * @throws IllegalArgumentException if there are too many, or if they overlap
   */
  FreeBodies(List<SceneObject> objects, List<ToolPoint> toolPoints) {
    this.objects = objects;
    points = toolPoints.isEmpty() ? List.of(new ToolPoint(new Vector3(0, 0, 0), 0)) : toolPoints;
    List<BodyDescription> all = new ArrayList<>();
    for (SceneObject object : objects) {
      all.add(body(object));
    }
    for (int i = 0; i < points.size(); i++) {
      double radiusM = Math.max(MIN_POINT_M, points.get(i).radiusM());
      // a line break is in no object's name
      all.add(
          BodyDescription.kinematic(
              "tool\n" + i,
              new BodyShape.Sphere(radiusM),
              Pose.ZERO,
              new BodySurface(Material.DEFAULT.friction(), 0, Material.STIFFNESS.most())));
    }
    bodies = new RigidBodyWorld(all, 0, 0, -ArmDynamics.STANDARD_GRAVITY_M_PER_S2);
  }

  /** Whether any object of a scene has a mass. */
  static boolean any(List<SceneObject> objects) {
    return objects.stream().anyMatch(each -> each.massKg() > 0);
  }

  /**
   * Checks the bodies of a scene.
   *
   * @throws IllegalArgumentException if there are too many, or if they overlap
   */
  static void require(List<SceneObject> objects, List<ToolPoint> toolPoints) {
    var _ = new FreeBodies(objects, toolPoints);
  }

  /** Sets gravity, m/s², along the axes of the base. */
  void setGravity(double x, double y, double z) {
    bodies.setGravity(x, y, z);
  }

  /**
   * Lets them move.
   *
   * @param onlyTcp whether the tool centre point is what touches
   */
  void advance(
      double[] flange12, double[] tcpInFlange3, boolean onlyTcp, double[] twist6, double stepS) {
    for (int i = 0; i < points.size(); i++) {
      Vector3 at = points.get(i).pointInFlangeM();
      double x = onlyTcp ? tcpInFlange3[0] : at.x();
      double y = onlyTcp ? tcpInFlange3[1] : at.y();
      double z = onlyTcp ? tcpInFlange3[2] : at.z();
      System.arraycopy(flange12, 0, ball12, 0, 9);
      for (int row = 0; row < 3; row++) {
        double arm = flange12[3 * row] * x + flange12[3 * row + 1] * y + flange12[3 * row + 2] * z;
        ballTwist6[row] = arm;
        ball12[9 + row] = flange12[9 + row] + arm;
      }
      double armX = ballTwist6[0];
      double armY = ballTwist6[1];
      double armZ = ballTwist6[2];
      ballTwist6[0] = twist6[0] + twist6[4] * armZ - twist6[5] * armY;
      ballTwist6[1] = twist6[1] + twist6[5] * armX - twist6[3] * armZ;
      ballTwist6[2] = twist6[2] + twist6[3] * armY - twist6[4] * armX;
      System.arraycopy(twist6, 3, ballTwist6, 3, 3);
      bodies.moveKinematic(objects.size() + i, ball12, ballTwist6);
    }
    bodies.advance(stepS);
    feel(flange12, tcpInFlange3, onlyTcp);
  }

  private void feel(double[] flange12, double[] tcpInFlange3, boolean onlyTcp) {
    Arrays.fill(felt6, 0);
    for (int i = 0; i < points.size(); i++) {
      bodies.wrench(objects.size() + i, ballWrench6);
      Vector3 at = points.get(i).pointInFlangeM();
      double x = onlyTcp ? tcpInFlange3[0] : at.x();
      double y = onlyTcp ? tcpInFlange3[1] : at.y();
      double z = onlyTcp ? tcpInFlange3[2] : at.z();
      double armX = flange12[0] * x + flange12[1] * y + flange12[2] * z;
      double armY = flange12[3] * x + flange12[4] * y + flange12[5] * z;
      double armZ = flange12[6] * x + flange12[7] * y + flange12[8] * z;
      for (int k = 0; k < 6; k++) {
        felt6[k] += ballWrench6[k];
      }
      felt6[3] += armY * ballWrench6[2] - armZ * ballWrench6[1];
      felt6[4] += armZ * ballWrench6[0] - armX * ballWrench6[2];
      felt6[5] += armX * ballWrench6[1] - armY * ballWrench6[0];
    }
  }

  /** Adds what the tool feels of them. */
  void addWrench(double[] wrench6) {
    for (int k = 0; k < 6; k++) {
      wrench6[k] += felt6[k];
    }
  }

  /** Whether one of them moves or is touched. */
  boolean move() {
    for (int i = 0; i < objects.size(); i++) {
      if (objects.get(i).massKg() > 0 && !bodies.sleeping(i)) {
        return true;
      }
    }
    return false;
  }

  /** Where object {@code i} of the scene is, as {@link Transforms} has it. */
  void pose(int i, double[] transform12) {
    bodies.pose(i, transform12);
  }

  private static BodyDescription body(SceneObject object) {
    Material material = object.material();
    BodySurface surface = new BodySurface(material.friction(), 0, material.stiffnessNPerM());
    return switch (object) {
      case SceneObject.Plane plane ->
          BodyDescription.fixed(plane.name(), new BodyShape.HalfSpace(), standing(plane), surface);
      case SceneObject.Box box -> {
        Vector3 size = box.sizeM();
        yield body(box, new BodyShape.Box(size.x(), size.y(), size.z()), box.poseInBase(), surface);
      }
      case SceneObject.Sphere ball -> {
        Vector3 at = ball.centreInBaseM();
        yield body(
            ball,
            new BodyShape.Sphere(ball.radiusM()),
            new Pose(at.x(), at.y(), at.z(), 0, 0, 0),
            surface);
      }
    };
  }

  private static BodyDescription body(
      SceneObject object, BodyShape shape, Pose pose, BodySurface surface) {
    return object.massKg() > 0
        ? BodyDescription.free(object.name(), shape, pose, object.massKg(), surface)
        : BodyDescription.fixed(object.name(), shape, pose, surface);
  }

  /** The pose whose z is the plane's normal. */
  private static Pose standing(SceneObject.Plane plane) {
    Vector3 n = plane.normalInBase();
    Vector3 at = plane.pointInBaseM();
    double across = Math.hypot(n.x(), n.y());
    double angle = Math.atan2(across, n.z());
    double rx = across > 0 ? -n.y() / across * angle : angle;
    double ry = across > 0 ? n.x() / across * angle : 0;
    return new Pose(at.x(), at.y(), at.z(), rx, ry, 0);
  }
}
