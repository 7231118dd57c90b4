package org.pendant.desktop.cell;

import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;

/** Object shape: what people read of the shape of an object, and its parts in other objects. */
final class ObjectShape {
  private ObjectShape() {}

  /** Such as {@code box}. */
  static String words(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane _ -> "plane";
      case SceneObject.Box _ -> "box";
      case SceneObject.Rod rod -> rod.type();
      case SceneObject.Mesh mesh -> "mesh " + mesh.part().file();
      case SceneObject.Sphere _ -> "ball";
    };
  }

  static SceneObject named(SceneObject object, String name) {
    return switch (object) {
      case SceneObject.Plane plane ->
          new SceneObject.Plane(name, plane.pointInBaseM(), plane.normalInBase(), plane.material());
      case SceneObject.Box box ->
          new SceneObject.Box(name, box.poseInBase(), box.sizeM(), box.material(), box.massKg());
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(
              name, mesh.poseInBase(), mesh.part(), mesh.material(), mesh.massKg());
      case SceneObject.Rod rod -> with(rod, name, rod.poseInBase(), rod.material(), rod.massKg());
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              name, ball.centreInBaseM(), ball.radiusM(), ball.material(), ball.massKg());
    };
  }

  static SceneObject of(SceneObject object, Material material) {
    return switch (object) {
      case SceneObject.Plane plane ->
          new SceneObject.Plane(plane.name(), plane.pointInBaseM(), plane.normalInBase(), material);
      case SceneObject.Box box ->
          new SceneObject.Box(box.name(), box.poseInBase(), box.sizeM(), material, box.massKg());
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(
              mesh.name(), mesh.poseInBase(), mesh.part(), material, mesh.massKg());
      case SceneObject.Rod rod -> with(rod, rod.name(), rod.poseInBase(), material, rod.massKg());
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              ball.name(), ball.centreInBaseM(), ball.radiusM(), material, ball.massKg());
    };
  }

  /**
   * Where it is in the base: a point of a plane, the origin of a mesh's file, the centre of others,
   * m.
   */
  static Vector3 placeM(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane plane -> plane.pointInBaseM();
      case SceneObject.Box box ->
          new Vector3(box.poseInBase().x(), box.poseInBase().y(), box.poseInBase().z());
      case SceneObject.Mesh mesh ->
          new Vector3(mesh.poseInBase().x(), mesh.poseInBase().y(), mesh.poseInBase().z());
      case SceneObject.Rod rod ->
          new Vector3(rod.poseInBase().x(), rod.poseInBase().y(), rod.poseInBase().z());
      case SceneObject.Sphere ball -> ball.centreInBaseM();
    };
  }

  /** The same one elsewhere in the base, m. */
  static SceneObject at(SceneObject object, Vector3 placeM) {
    return switch (object) {
      case SceneObject.Plane plane ->
          new SceneObject.Plane(plane.name(), placeM, plane.normalInBase(), plane.material());
      case SceneObject.Box box -> {
        Pose pose = box.poseInBase();
        yield new SceneObject.Box(
            box.name(),
            new Pose(placeM.x(), placeM.y(), placeM.z(), pose.rx(), pose.ry(), pose.rz()),
            box.sizeM(),
            box.material(),
            box.massKg());
      }
      case SceneObject.Mesh mesh -> {
        Pose pose = mesh.poseInBase();
        yield new SceneObject.Mesh(
            mesh.name(),
            new Pose(placeM.x(), placeM.y(), placeM.z(), pose.rx(), pose.ry(), pose.rz()),
            mesh.part(),
            mesh.material(),
            mesh.massKg());
      }
      case SceneObject.Rod rod -> {
        Pose pose = rod.poseInBase();
        yield with(
            rod,
            rod.name(),
            new Pose(placeM.x(), placeM.y(), placeM.z(), pose.rx(), pose.ry(), pose.rz()),
            rod.material(),
            rod.massKg());
      }
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              ball.name(), placeM, ball.radiusM(), ball.material(), ball.massKg());
    };
  }

  /** The same one with another mass, kg; 0 for one that stands still. */
  static SceneObject weighing(SceneObject object, double massKg) {
    return switch (object) {
      case SceneObject.Plane plane -> plane;
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(
              mesh.name(), mesh.poseInBase(), mesh.part(), mesh.material(), massKg);
      case SceneObject.Box box ->
          new SceneObject.Box(box.name(), box.poseInBase(), box.sizeM(), box.material(), massKg);
      case SceneObject.Rod rod -> with(rod, rod.name(), rod.poseInBase(), rod.material(), massKg);
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              ball.name(), ball.centreInBaseM(), ball.radiusM(), ball.material(), massKg);
    };
  }

  private static SceneObject with(
      SceneObject.Rod rod, String name, Pose pose, Material material, double massKg) {
    return new SceneObject.Rod(
        name, pose, rod.radiusM(), rod.lengthM(), rod.capsule(), material, massKg);
  }
}
