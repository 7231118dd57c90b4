package org.pendant.sweep.run;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;
import org.pendant.sweep.plan.FrameAxis;

/** Cell shift: what is around an arm, elsewhere. */
final class CellShift {
  private CellShift() {}

  /** A pose that is displaced along or about axes like those of the base through its own origin. */
  static Pose displaced(Pose pose, FrameAxis axis, double amount) {
    if (axis.ordinal() < 3) {
      return pose.with(axis.ordinal(), pose.get(axis.ordinal()) + amount);
    }
    Pose turned =
        Poses.trans(axis.displacement(amount), new Pose(0, 0, 0, pose.rx(), pose.ry(), pose.rz()));
    return new Pose(pose.x(), pose.y(), pose.z(), turned.rx(), turned.ry(), turned.rz());
  }

  /** The scene with one object displaced. */
  static Scene withObject(Scene scene, String name, FrameAxis axis, double amount) {
    return scene.withObjects(
        scene.objects().stream()
            .map(
                each ->
                    each.name().equals(name)
                        ? moved(each, pose -> displaced(pose, axis, amount))
                        : each)
            .toList());
  }

  /** Features with one of them displaced; a frame of several points moves as one. */
  static List<Feature> withFeature(
      List<Feature> features, String name, FrameAxis axis, double amount) {
    List<Feature> all = new ArrayList<>();
    for (Feature each : features) {
      if (each.name().equals(name) && !each.points().isEmpty()) {
        Pose origin = each.points().getFirst();
        Pose by = Poses.trans(displaced(origin, axis, amount), Poses.inverse(origin));
        all.add(moved(each, by));
      } else {
        all.add(each);
      }
    }
    return all;
  }

  /** A feature seen from another frame. */
  static Feature moved(Feature feature, Pose by) {
    return new Feature(
        feature.name(),
        feature.kind(),
        feature.points().stream().map(each -> Poses.trans(by, each)).toList(),
        feature.variable(),
        feature.joggable());
  }

  /**
   * A scene seen from a base that stands elsewhere.
   *
   * @param by the old base frame in the new one
   */
  static Scene seenFrom(Scene scene, Pose by) {
    Wrench push = scene.pushAtTcpInBase();
    Vector3 force = turned(by, new Vector3(push.fx(), push.fy(), push.fz()));
    Vector3 torque = turned(by, new Vector3(push.mx(), push.my(), push.mz()));
    return new Scene(
        scene.objects().stream().map(each -> moved(each, pose -> Poses.trans(by, pose))).toList(),
        scene.load(),
        scene.toolPoints(),
        scene.toolBodies(),
        new Wrench(force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z()),
        scene.links());
  }

  /** Safety planes seen from a base that stands elsewhere. */
  static SafetyConfiguration seenFrom(SafetyConfiguration safety, Pose by) {
    return safety.withPlanes(
        safety.planes().stream().map(each -> seenFrom(each, by)).toArray(SafetyPlane[]::new));
  }

  private static SafetyPlane seenFrom(SafetyPlane plane, Pose by) {
    Pose point =
        Poses.trans(by, new Pose(plane.pointXM(), plane.pointYM(), plane.pointZM(), 0, 0, 0));
    Axis side = plane.allowedSide();
    Vector3 turned = turned(by, new Vector3(side.x(), side.y(), side.z()));
    return new SafetyPlane(
        plane.name(),
        point.x(),
        point.y(),
        point.z(),
        new Axis(turned.x(), turned.y(), turned.z()),
        plane.applies(),
        plane.elbow());
  }

  /** Whether a device has a place of its own in the cell, which does not move with the scene. */
  static boolean standsInCell(DeviceSetup device) {
    return switch (device) {
      case DeviceSetup.Sensor _, DeviceSetup.Switch _, DeviceSetup.Camera _, DeviceSetup.Sink _ ->
          true;
      case DeviceSetup.TwoFinger _,
          DeviceSetup.RpcGripper _,
          DeviceSetup.Driven _,
          DeviceSetup.Door _,
          DeviceSetup.Vacuum _,
          DeviceSetup.Belt _,
          DeviceSetup.Source _,
          DeviceSetup.Lamp _,
          DeviceSetup.Modbus _,
          DeviceSetup.EthernetIp _,
          DeviceSetup.Rail _ ->
          false;
    };
  }

  private static Vector3 turned(Pose by, Vector3 vector) {
    Pose turned =
        Poses.trans(
            new Pose(0, 0, 0, by.rx(), by.ry(), by.rz()),
            new Pose(vector.x(), vector.y(), vector.z(), 0, 0, 0));
    return new Vector3(turned.x(), turned.y(), turned.z());
  }

  private static SceneObject moved(SceneObject object, UnaryOperator<Pose> by) {
    return switch (object) {
      case SceneObject.Plane plane -> moved(plane, by);
      case SceneObject.Box box ->
          new SceneObject.Box(
              box.name(), by.apply(box.poseInBase()), box.sizeM(), box.material(), box.massKg());
      case SceneObject.Rod rod ->
          new SceneObject.Rod(
              rod.name(),
              by.apply(rod.poseInBase()),
              rod.radiusM(),
              rod.lengthM(),
              rod.capsule(),
              rod.material(),
              rod.massKg());
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(
              mesh.name(),
              by.apply(mesh.poseInBase()),
              mesh.part(),
              mesh.material(),
              mesh.massKg());
      case SceneObject.Compound compound -> compound.at(by.apply(compound.poseInBase()));
      case SceneObject.Sphere ball -> {
        Vector3 centre = ball.centreInBaseM();
        Pose pose = by.apply(new Pose(centre.x(), centre.y(), centre.z(), 0, 0, 0));
        yield new SceneObject.Sphere(
            ball.name(),
            new Vector3(pose.x(), pose.y(), pose.z()),
            ball.radiusM(),
            ball.material(),
            ball.massKg());
      }
    };
  }

  private static SceneObject moved(SceneObject.Plane plane, UnaryOperator<Pose> by) {
    Vector3 point = plane.pointInBaseM();
    Pose pose = by.apply(new Pose(point.x(), point.y(), point.z(), 0, 0, 0));
    Vector3 normal = turned(pose, plane.normalInBase());
    return new SceneObject.Plane(
        plane.name(), new Vector3(pose.x(), pose.y(), pose.z()), normal, plane.material());
  }
}
