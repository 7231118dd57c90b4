package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

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
      case SceneObject.Plane _ -> text("planeWord");
      case SceneObject.Box _ -> text("boxWord");
      case SceneObject.Rod rod -> text(rod.capsule() ? "capsuleWord" : "cylinderWord");
      case SceneObject.Mesh mesh -> text("meshOf", mesh.part().file());
      case SceneObject.Sphere _ -> text("ballWord");
      case SceneObject.Compound compound -> text("compoundOf", compound.parts().size());
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
      case SceneObject.Compound compound -> compound.named(name);
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
      case SceneObject.Compound compound -> compound.of(material);
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
    Pose pose = object.poseInBase();
    return new Vector3(pose.x(), pose.y(), pose.z());
  }

  /** The same one elsewhere in the base, m. */
  static SceneObject at(SceneObject object, Vector3 placeM) {
    Pose pose = object.poseInBase();
    return at(
        object, new Pose(placeM.x(), placeM.y(), placeM.z(), pose.rx(), pose.ry(), pose.rz()));
  }

  /** The same one at another pose, of which planes and balls take the place alone. */
  static SceneObject at(SceneObject object, Pose pose) {
    Vector3 placeM = new Vector3(pose.x(), pose.y(), pose.z());
    return switch (object) {
      case SceneObject.Plane plane ->
          new SceneObject.Plane(plane.name(), placeM, plane.normalInBase(), plane.material());
      case SceneObject.Box box ->
          new SceneObject.Box(box.name(), pose, box.sizeM(), box.material(), box.massKg());
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(mesh.name(), pose, mesh.part(), mesh.material(), mesh.massKg());
      case SceneObject.Rod rod -> with(rod, rod.name(), pose, rod.material(), rod.massKg());
      case SceneObject.Compound compound -> compound.at(pose);
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              ball.name(), placeM, ball.radiusM(), ball.material(), ball.massKg());
    };
  }

  /** The same one with another mass, kg; 0 for one that stands still. */
  static SceneObject weighing(SceneObject object, double massKg) {
    return switch (object) {
      case SceneObject.Plane plane -> plane;
      case SceneObject.Compound compound -> compound.weighing(massKg);
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
