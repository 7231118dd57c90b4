package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import org.pendant.models.pose.Pose;

/** Seen scene: a scene as it is seen from the base of an arm that stands somewhere in it. */
public final class SeenScene {
  private final ArmPlace place;

  private SeenScene(Pose baseInCell) {
    place = new ArmPlace(baseInCell);
  }

  /**
   * The same objects in the base frame of an arm; the same scene for an arm at the origin.
   *
   * @param baseInCell where the arm stands in the frame of {@code scene}
   * @throws IllegalArgumentException if an object is farther away from the base than a scene allows
   */
  public static Scene of(Scene scene, Pose baseInCell) {
    SeenScene from = new SeenScene(baseInCell);
    return from.place.origin()
        ? scene
        : scene.withObjects(scene.objects().stream().map(from::seen).toList());
  }

  private SceneObject seen(SceneObject object) {
    try {
      return moved(object);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(text("tooFar", object.name(), e.getMessage()), e);
    }
  }

  private SceneObject moved(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane plane -> plane(plane);
      case SceneObject.Box box ->
          new SceneObject.Box(
              box.name(),
              place.inBase(box.poseInBase()),
              box.sizeM(),
              box.material(),
              box.massKg());
      case SceneObject.Compound compound -> compound.at(place.inBase(compound.poseInBase()));
      case SceneObject.Rod rod ->
          new SceneObject.Rod(
              rod.name(),
              place.inBase(rod.poseInBase()),
              rod.radiusM(),
              rod.lengthM(),
              rod.capsule(),
              rod.material(),
              rod.massKg());
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(
              mesh.name(),
              place.inBase(mesh.poseInBase()),
              mesh.part(),
              mesh.material(),
              mesh.massKg());
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              ball.name(),
              point(ball.centreInBaseM()),
              ball.radiusM(),
              ball.material(),
              ball.massKg());
    };
  }

  private Vector3 point(Vector3 inCellM) {
    Pose at = place.inBase(new Pose(inCellM.x(), inCellM.y(), inCellM.z(), 0, 0, 0));
    return new Vector3(at.x(), at.y(), at.z());
  }

  /** The point of the plane that is nearest the base stands for it. */
  private SceneObject plane(SceneObject.Plane plane) {
    Vector3 end = plane.normalInBase();
    Vector3 from = point(new Vector3(0, 0, 0));
    Vector3 to = point(end);
    Vector3 normal = new Vector3(to.x() - from.x(), to.y() - from.y(), to.z() - from.z()).unit();
    Vector3 at = point(plane.pointInBaseM());
    double heightM = normal.x() * at.x() + normal.y() * at.y() + normal.z() * at.z();
    return new SceneObject.Plane(
        plane.name(),
        new Vector3(heightM * normal.x(), heightM * normal.y(), heightM * normal.z()),
        normal,
        plane.material());
  }
}
