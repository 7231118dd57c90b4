package org.pendant.desktop.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.Finish;

/**
 * Sheets: everything flat that can be seen through, in the order in which it has to be drawn: what
 * is farther away first, and before the ghost what is behind the arm.
 */
public final class Sheets {
  /** Half the side of a safety plane's square, as a share of the arm's reach. */
  private static final double SQUARE_SHARE = 0.7;

  private static final float[] NAME_SHARES = {1, 0.7f, 0.4f, 0.1f};
  private static final int[][] CORNERS = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  private static final float PLANE_OPACITY = 0.3f;

  private Sheets() {}

  /**
   * One sheet.
   *
   * @param frame its z axis is the normal
   * @param rgb its colour, 0xRRGGBB
   * @param halfSizeM half the side of its square, m; 0 for one that fades out with the distance
   * @param behind whether the arm is on the side of the eye
   */
  public record Sheet(Matrix4f frame, int rgb, float opacity, double halfSizeM, boolean behind) {}

  /** The sheets of a model as an eye in the base frame sees them, the farthest first. */
  public static List<Sheet> of(SceneModel model, Ground ground, Vector3 eyeM) {
    Vector3f eye = new Vector3f((float) eyeM.x(), (float) eyeM.y(), (float) eyeM.z());
    Vector3f shoulder = new Vector3f(0, 0, (float) model.arm().dh().d1());
    List<Sheet> sheets = new ArrayList<>();
    for (Ground.Patch patch : ground.planes()) {
      int rgb = model.theme().rgb(patch.touched() ? Finish.TOUCHED : Finish.OBJECT);
      sheets.add(
          new Sheet(patch.frame(), rgb, PLANE_OPACITY, 0, oneSide(patch.frame(), eye, shoulder)));
    }
    for (SafetySight.Plane each : model.safety().planes()) {
      Matrix4f frame = frame(each.plane(), model);
      sheets.add(
          new Sheet(
              frame,
              SafetyColours.rgb(each.plane().applies(), each.state(), model.theme()),
              SafetyColours.opacity(each.state()),
              halfSizeM(model),
              oneSide(frame, eye, shoulder)));
    }
    sheets.sort(
        Comparator.comparingDouble(
            (Sheet sheet) -> -sheet.frame.getTranslation(new Vector3f()).distance(eye)));
    return sheets;
  }

  /** Half the side of a safety plane's square, m. */
  static double halfSizeM(SceneModel model) {
    return SQUARE_SHARE * model.arm().reachM();
  }

  /** Where a safety plane lies; z leads to the allowed side. */
  static Matrix4f frame(SafetyPlane plane, SceneModel model) {
    Axis side = plane.allowedSide();
    return PlaneFrame.of(
        new Vector3f((float) side.x(), (float) side.y(), (float) side.z()),
        new Vector3f((float) plane.pointXM(), (float) plane.pointYM(), (float) plane.pointZM()),
        model.arm().dh().d1());
  }

  /** Where a plane's name may stand, the best place first: corners of its square, then within. */
  public static List<Vector3> namePlaces(SafetyPlane plane, SceneModel model) {
    Matrix4f frame = frame(plane, model);
    List<Vector3> places = new ArrayList<>();
    for (float share : NAME_SHARES) {
      float away = share * (float) halfSizeM(model);
      for (int[] corner : CORNERS) {
        Vector3f at = frame.transformPosition(new Vector3f(corner[0] * away, corner[1] * away, 0));
        places.add(new Vector3(at.x, at.y, at.z));
      }
    }
    return places;
  }

  private static boolean oneSide(Matrix4f frame, Vector3f eye, Vector3f shoulder) {
    Vector3f normal = frame.transformDirection(new Vector3f(0, 0, 1));
    Vector3f origin = frame.getTranslation(new Vector3f());
    return new Vector3f(eye).sub(origin).dot(normal)
            * new Vector3f(shoulder).sub(origin).dot(normal)
        >= 0;
  }
}
