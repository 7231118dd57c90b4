package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.SceneObject;
import org.pendant.desktop.scene.mesh.Finish;
import org.pendant.desktop.scene.mesh.Lines;

/** Belt outlines: chevrons on the surface of belts, which go along with it. */
public final class BeltOutlines {
  private static final double SPACING_M = 0.1;
  private static final double OPACITY = 0.7;

  /** Above the surface, so that it hides none of them. */
  private static final float ABOVE_M = 0.0008f;

  /** Of half the width of the belt: how far a chevron points, and how wide it is. */
  private static final float POINT = 0.35f;

  private static final float WIDE = 0.75f;

  private BeltOutlines() {}

  /** The box of a belt; empty where the scene has none. */
  public static Optional<SceneObject.Box> box(DeviceSight.Belt belt, List<SceneObject> objects) {
    for (SceneObject each : objects) {
      if (each instanceof SceneObject.Box box && box.name().equals(belt.object())) {
        return Optional.of(box);
      }
    }
    return Optional.empty();
  }

  /** The lines on all belts among some objects. */
  public static Lines of(
      List<DeviceSight.Belt> belts, List<SceneObject> objects, SceneTheme theme) {
    Lines lines = new Lines();
    for (DeviceSight.Belt belt : belts) {
      box(belt, objects).ifPresent(box -> add(lines, belt, box, theme.rgb(Finish.SEAL)));
    }
    return lines;
  }

  private static void add(Lines lines, DeviceSight.Belt belt, SceneObject.Box box, int rgb) {
    Matrix4f frame = LinkPlaces.matrix(box.poseInBase());
    float halfLength = (float) box.sizeM().x() / 2;
    float halfWidth = (float) box.sizeM().y() / 2;
    float top = (float) box.sizeM().z() / 2 + ABOVE_M;
    float point = (belt.backwards() ? -POINT : POINT) * halfWidth;
    double first = belt.travelM() - SPACING_M * Math.floor(belt.travelM() / SPACING_M);
    for (double at = first - halfLength; at <= halfLength; at += SPACING_M) {
      float tip = (float) at;
      float back = tip - point;
      if (Math.abs(back) <= halfLength) {
        Vector3f one = at(frame, back, WIDE * halfWidth, top);
        Vector3f middle = at(frame, tip, 0, top);
        Vector3f other = at(frame, back, -WIDE * halfWidth, top);
        lines
            .from(one.x, one.y, one.z, rgb, OPACITY)
            .to(middle.x, middle.y, middle.z, rgb, OPACITY)
            .to(other.x, other.y, other.z, rgb, OPACITY);
      }
    }
  }

  private static Vector3f at(Matrix4f frame, float x, float y, float z) {
    return frame.transformPosition(new Vector3f(x, y, z));
  }
}
