package org.pendant.desktop.scene.mesh;

import java.util.List;
import java.util.Set;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;

/** Box edges of a scene: two boxes of one colour in front of each other stay two. */
public final class BoxEdges {
  private static final int CORNERS = 8;

  private BoxEdges() {}

  /**
   * The edges of some objects; only boxes have any.
   *
   * @param touched names of those that look touched
   * @param rgb colour as 0xRRGGBB
   * @param touchedRgb colour of what is touched
   */
  public static Lines of(List<SceneObject> objects, Set<String> touched, int rgb, int touchedRgb) {
    Lines lines = new Lines();
    for (SceneObject object : objects) {
      for (SceneObject piece : object.pieces()) {
        if (piece instanceof SceneObject.Box box) {
          add(lines, box, touched.contains(box.name()) ? touchedRgb : rgb);
        }
      }
    }
    return lines;
  }

  private static void add(Lines lines, SceneObject.Box box, int rgb) {
    Matrix4f frame = WorldMesh.frame(box.poseInBase());
    for (int corner = 0; corner < CORNERS; corner++) {
      for (int axis = 1; axis < CORNERS; axis <<= 1) {
        if ((corner & axis) == 0) {
          Vector3f from = corner(frame, box.sizeM(), corner);
          Vector3f to = corner(frame, box.sizeM(), corner | axis);
          lines.from(from.x, from.y, from.z, rgb, 1).to(to.x, to.y, to.z, rgb, 1);
        }
      }
    }
  }

  private static Vector3f corner(Matrix4f frame, Vector3 size, int corner) {
    return frame.transformPosition(
        new Vector3f(
            half(size.x(), corner & 1), half(size.y(), corner & 2), half(size.z(), corner & 4)));
  }

  private static float half(double length, int far) {
    return (float) (far == 0 ? -length / 2 : length / 2);
  }
}
