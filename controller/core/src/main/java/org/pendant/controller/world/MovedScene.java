package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

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
   *     names stay where they were, and those that have left the space of a scene are not there
   */
  public static Scene of(Scene scene, List<MovedObject> moved) {
    if (moved.isEmpty()) {
      return scene;
    }
    List<SceneObject> objects = new ArrayList<>(scene.objects());
    for (MovedObject each : moved) {
      int place = place(objects, each.name());
      int original = place(scene.objects(), each.original());
      boolean there =
          each.there() && original >= 0 && within(scene.objects().get(original), each.poseInBase());
      if (place >= 0 && there) {
        objects.set(place, at(objects.get(place), each.name(), each.poseInBase()));
      } else if (place >= 0) {
        objects.remove(place);
      } else if (original >= 0 && there) {
        objects.add(at(scene.objects().get(original), each.name(), each.poseInBase()));
      }
    }
    return scene.withObjects(objects);
  }

  /** Whether all of an object is where a scene may have something: what falls leaves it. */
  private static boolean within(SceneObject object, Pose pose) {
    return object instanceof SceneObject.Compound compound
        ? SceneRange.holds(pose)
            && compound.parts().stream()
                .allMatch(part -> SceneRange.holds(Poses.trans(pose, part.poseInBase())))
        : SceneRange.holds(pose);
  }

  private static int place(List<SceneObject> objects, String name) {
    for (int i = 0; i < objects.size(); i++) {
      if (objects.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** An object elsewhere, by another name and without a mass. */
  static SceneObject at(SceneObject object, String name, Pose pose) {
    return switch (object) {
      case SceneObject.Plane plane -> plane;
      case SceneObject.Mesh mesh -> new SceneObject.Mesh(name, pose, mesh.part(), mesh.material());
      case SceneObject.Compound compound -> compound.weighing(0).named(name).at(pose);
      case SceneObject.Box box -> new SceneObject.Box(name, pose, box.sizeM(), box.material());
      case SceneObject.Rod rod ->
          new SceneObject.Rod(
              name, pose, rod.radiusM(), rod.lengthM(), rod.capsule(), rod.material(), 0);
      case SceneObject.Sphere ball ->
          new SceneObject.Sphere(
              name, new Vector3(pose.x(), pose.y(), pose.z()), ball.radiusM(), ball.material());
    };
  }
}
