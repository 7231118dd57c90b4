package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;

/**
 * Moved scene: a scene with its objects where they are at one moment, to be looked at. They have no
 * mass there: things that are pressed together may be in one another, which no scene begins with.
 */
public final class MovedScene {
  private MovedScene() {}

  /**
   * The scene then.
   *
   * @param moved the objects that may be elsewhere, or away, and copies of them; those of other
   *     names stay where they were
   */
  public static Scene of(Scene scene, List<MovedObject> moved) {
    if (moved.isEmpty()) {
      return scene;
    }
    List<SceneObject> objects = new ArrayList<>(scene.objects());
    for (MovedObject each : moved) {
      int place = place(objects, each.name());
      int original = place(scene.objects(), each.original());
      if (place >= 0 && each.there()) {
        objects.set(place, at(objects.get(place), each));
      } else if (place >= 0) {
        objects.remove(place);
      } else if (original >= 0 && each.there()) {
        objects.add(at(scene.objects().get(original), each));
      }
    }
    return scene.withObjects(objects);
  }

  private static int place(List<SceneObject> objects, String name) {
    for (int i = 0; i < objects.size(); i++) {
      if (objects.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }

  private static SceneObject at(SceneObject object, MovedObject moved) {
    Pose pose = moved.poseInBase();
    return switch (object) {
      case SceneObject.Plane plane -> plane;
      case SceneObject.Mesh mesh ->
          new SceneObject.Mesh(moved.name(), pose, mesh.part(), mesh.material());
      case SceneObject.Box box ->
          new SceneObject.Box(moved.name(), pose, box.sizeM(), box.material());
      case SceneObject.Rod rod ->
          new SceneObject.Rod(
              moved.name(), pose, rod.radiusM(), rod.lengthM(), rod.capsule(), rod.material(), 0);
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              moved.name(),
              new Vector3(pose.x(), pose.y(), pose.z()),
              ball.radiusM(),
              ball.material());
    };
  }
}
