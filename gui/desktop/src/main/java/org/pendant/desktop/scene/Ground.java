package org.pendant.desktop.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;

/**
 * Ground: the floor, and the planes of a scene besides it.
 *
 * @param heightM the floor's, m: that of the lowest plane that faces up, or 0
 * @param touched whether the tool touches the plane that is the floor
 * @param planes the other planes
 */
public record Ground(double heightM, boolean touched, List<Patch> planes) {
  /** A plane this level is a floor: the cosine of a tenth of a degree and less. */
  private static final double LEVEL = 0.999998;

  /**
   * A plane that is no floor.
   *
   * @param touched whether the tool touches it
   * @param frame its z axis leads out of the solid, its origin is the point next to the shoulder
   */
  public record Patch(boolean touched, Matrix4f frame) {}

  /** Copies the list. */
  public Ground {
    planes = List.copyOf(planes);
  }

  /** What a model stands on and between. */
  public static Ground of(SceneModel model) {
    Optional<SceneObject.Plane> floor = floor(model.world());
    List<Patch> planes = new ArrayList<>();
    for (SceneObject object : model.world().objects()) {
      if (object instanceof SceneObject.Plane plane && !floor.equals(Optional.of(plane))) {
        planes.add(
            new Patch(model.touched().contains(plane.name()), frame(plane, model.arm().dh().d1())));
      }
    }
    return new Ground(
        floor.map(plane -> plane.pointInBaseM().z()).orElse(0.0),
        floor.filter(plane -> model.touched().contains(plane.name())).isPresent(),
        planes);
  }

  private static Optional<SceneObject.Plane> floor(Scene world) {
    SceneObject.Plane lowest = null;
    for (SceneObject object : world.objects()) {
      if (object instanceof SceneObject.Plane plane
          && plane.normalInBase().z() > LEVEL
          && (lowest == null || plane.pointInBaseM().z() < lowest.pointInBaseM().z())) {
        lowest = plane;
      }
    }
    return Optional.ofNullable(lowest);
  }

  private static Matrix4f frame(SceneObject.Plane plane, double shoulderHeightM) {
    Vector3f normal =
        new Vector3f(
            (float) plane.normalInBase().x(),
            (float) plane.normalInBase().y(),
            (float) plane.normalInBase().z());
    Vector3f point =
        new Vector3f(
            (float) plane.pointInBaseM().x(),
            (float) plane.pointInBaseM().y(),
            (float) plane.pointInBaseM().z());
    return PlaneFrame.of(normal, point, shoulderHeightM);
  }
}
