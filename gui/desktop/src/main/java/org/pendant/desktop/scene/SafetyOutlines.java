package org.pendant.desktop.scene;

import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.SafetySight.State;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Transforms;

/**
 * Safety outlines: those of what bounds the arm: the squares of planes with arrows to the allowed
 * side, cones of the tool direction, ranges of joints, and how far the arm reaches.
 */
public final class SafetyOutlines {
  private static final double ARROW_SHARE = 0.12;
  private static final double INNER_SQUARE = 0.94;
  private static final double ARROW_PLACE = 0.8;
  private static final double CONE_SHARE = 0.2;
  private static final double TOOL_AXIS = 1.25;
  private static final double LARGE_ARC_SHARE = 0.19;
  private static final double SMALL_ARC_SHARE = 0.14;
  private static final double FORBIDDEN_OPACITY = 0.9;
  private static final double REACH_OPACITY = 0.55;
  private static final double STEP_RAD = Math.toRadians(3);
  private static final int WRIST = 3;
  private static final int DASHES = 24;
  private static final int ROUND = 96;
  private static final int RIBS = 24;

  private final SceneModel model;
  private final Lines lines = new Lines();

  private SafetyOutlines(SceneModel model) {
    this.model = model;
  }

  /** The lines of a model; none while nothing of its safety functions is to be seen. */
  public static Lines of(SceneModel model) {
    SafetyOutlines made = new SafetyOutlines(model);
    SafetySight sight = model.safety();
    sight.planes().forEach(made::plane);
    sight.directions().forEach(made::direction);
    sight.joints().forEach(made::range);
    if (sight.reach()) {
      made.reach();
    }
    return made.lines;
  }

  /** Where the name of a joint's range stands: at the end of its pointer. */
  public static Vector3 namePlace(SafetySight.Range range, SceneModel model) {
    Vector3f at =
        JointCircle.of(model, range.joint())
            .at(radiusM(range, model), model.positionRad().get(range.joint()));
    return new Vector3(at.x, at.y, at.z);
  }

  private static double radiusM(SafetySight.Range range, SceneModel model) {
    return model.arm().reachM() * (range.joint() < WRIST ? LARGE_ARC_SHARE : SMALL_ARC_SHARE);
  }

  private void plane(SafetySight.Plane each) {
    Matrix4f frame = Sheets.frame(each.plane(), model);
    int rgb = SafetyColours.rgb(each.plane().applies(), each.state(), model.theme());
    double half = Sheets.halfSizeM(model);
    square(frame, half, rgb, each.state());
    if (each.plane().elbow()) {
      square(frame, INNER_SQUARE * half, rgb, each.state());
    }
    double away = ARROW_PLACE * half;
    for (int i = 0; i < 4; i++) {
      arrow(frame, (i & 1) == 0 ? -away : away, (i & 2) == 0 ? -away : away, rgb);
    }
  }

  private void square(Matrix4f frame, double half, int rgb, State state) {
    double[][] corners = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    for (int i = 0; i < corners.length; i++) {
      double[] a = corners[i];
      double[] b = corners[(i + 1) % corners.length];
      line(at(frame, a[0], a[1], 0), at(frame, b[0], b[1], 0), rgb, SafetyColours.dashed(state));
    }
  }

  /** From the plane to the allowed side. */
  private void arrow(Matrix4f frame, double x, double y, int rgb) {
    double length = ARROW_SHARE * model.arm().reachM();
    double head = 0.3 * length;
    Vector3f tip = at(frame, x, y, length);
    line(at(frame, x, y, 0), tip, rgb, false);
    line(at(frame, x - 0.5 * head, y, length - head), tip, rgb, false);
    line(at(frame, x + 0.5 * head, y, length - head), tip, rgb, false);
    line(at(frame, x, y - 0.5 * head, length - head), tip, rgb, false);
    line(at(frame, x, y + 0.5 * head, length - head), tip, rgb, false);
  }

  /** The cone within which the tool's own axis stays, its tip at the tool. */
  private void direction(SafetySight.Direction each) {
    int rgb = SafetyColours.rgb(each.limit().applies(), each.state(), model.theme());
    Vector3f tip = LinkPlaces.matrix(model.tcpInBase()).getTranslation(new Vector3f());
    Vector3f along = vector(each.limit().allowedInBase());
    Matrix4f frame = PlaneFrame.of(along, tip, 0);
    frame.setTranslation(tip);
    double length = CONE_SHARE * model.arm().reachM();
    double radius = length * Math.sin(each.limit().largestAngleRad());
    double depth = length * Math.cos(each.limit().largestAngleRad());
    boolean dashed = SafetyColours.dashed(each.state());
    circle(frame, radius, depth, rgb, dashed, 1);
    for (int i = 0; i < RIBS; i++) {
      double a = 2 * Math.PI * i / RIBS;
      rib(tip, at(frame, radius * Math.cos(a), radius * Math.sin(a), depth), rgb, i % 6 == 0);
    }
    Matrix4f flange = LinkPlaces.matrix(model.kinematics().flangePose(model.positionRad()));
    Vector3f own = flange.transformDirection(vector(each.limit().toolInFlange()));
    line(tip, new Vector3f(tip).fma((float) (TOOL_AXIS * length), own), rgb, false);
  }

  private void rib(Vector3f tip, Vector3f end, int rgb, boolean strong) {
    double opacity = strong ? 0.8 : 0.3;
    lines.from(tip.x, tip.y, tip.z, rgb, opacity).to(end.x, end.y, end.z, rgb, opacity);
  }

  private static Vector3f vector(Axis axis) {
    return new Vector3f((float) axis.x(), (float) axis.y(), (float) axis.z());
  }

  /** An arc around the joint: what it may do of a turn, where it may not, and where it is. */
  private void range(SafetySight.Range each) {
    JointCircle circle = JointCircle.of(model, each.joint());
    double q = model.positionRad().get(each.joint());
    double radius = radiusM(each, model);
    int rgb = SafetyColours.rgb(Applies.BOTH, each.state(), model.theme());
    int forbidden = SafetyColours.forbiddenRgb(model.theme());
    double from = Math.max(each.minRad(), q - Math.PI);
    double to = Math.min(each.maxRad(), q + Math.PI);
    arc(circle, radius, from, to, rgb, 1);
    arc(circle, 0.9 * radius, from, to, rgb, 0.35);
    if (from > q - Math.PI) {
      arc(circle, radius, Math.min(from, q) - Math.PI / 4, from, forbidden, FORBIDDEN_OPACITY);
      spoke(circle, 0.6 * radius, 1.15 * radius, from, forbidden);
    }
    if (to < q + Math.PI) {
      arc(circle, radius, to, Math.max(to, q) + Math.PI / 4, forbidden, FORBIDDEN_OPACITY);
      spoke(circle, 0.6 * radius, 1.15 * radius, to, forbidden);
    }
    spoke(circle, 0, 1.1 * radius, q, rgb);
  }

  private void arc(
      JointCircle circle, double radius, double from, double to, int rgb, double opacity) {
    int steps = (int) Math.max(1, Math.ceil((to - from) / STEP_RAD));
    for (int i = 0; to > from && i <= steps; i++) {
      Vector3f p = circle.at(radius, from + (to - from) * i / steps);
      if (i == 0) {
        lines.from(p.x, p.y, p.z, rgb, opacity);
      } else {
        lines.to(p.x, p.y, p.z, rgb, opacity);
      }
    }
  }

  private void spoke(JointCircle circle, double from, double to, double angleRad, int rgb) {
    line(circle.at(from, angleRad), circle.at(to, angleRad), rgb, false);
  }

  /** A ball around the shoulder, without the column over the base that the wrist cannot enter. */
  private void reach() {
    int rgb = model.theme().gridRgb();
    double reachM = model.arm().reachM();
    Matrix4f shoulder = new Matrix4f().translation(0, 0, (float) model.arm().dh().d1());
    float quarter = (float) (Math.PI / 2);
    circle(shoulder, reachM, 0, rgb, false, REACH_OPACITY);
    circle(new Matrix4f(shoulder).rotateX(quarter), reachM, 0, rgb, false, REACH_OPACITY);
    circle(new Matrix4f(shoulder).rotateY(quarter), reachM, 0, rgb, false, REACH_OPACITY);
    double columnM = model.arm().dh().d4();
    double heightM = Math.sqrt(Math.max(0, reachM * reachM - columnM * columnM));
    circle(shoulder, columnM, heightM, rgb, false, REACH_OPACITY);
    circle(shoulder, columnM, -heightM, rgb, false, REACH_OPACITY);
    for (int i = 0; i < 8; i++) {
      double a = Math.PI * i / 4;
      Vector3f low = at(shoulder, columnM * Math.cos(a), columnM * Math.sin(a), -heightM);
      Vector3f high = at(shoulder, columnM * Math.cos(a), columnM * Math.sin(a), heightM);
      lines
          .from(low.x, low.y, low.z, rgb, REACH_OPACITY)
          .to(high.x, high.y, high.z, rgb, REACH_OPACITY);
    }
  }

  private void circle(
      Matrix4f frame, double radius, double z, int rgb, boolean dashed, double opacity) {
    for (int i = 0; i <= ROUND; i++) {
      double a = 2 * Math.PI * i / ROUND;
      Vector3f p = at(frame, radius * Math.cos(a), radius * Math.sin(a), z);
      if (i == 0 || (dashed && i / 2 % 2 == 1)) {
        lines.from(p.x, p.y, p.z, rgb, opacity);
      } else {
        lines.to(p.x, p.y, p.z, rgb, opacity);
      }
    }
  }

  private void line(Vector3f a, Vector3f b, int rgb, boolean dashed) {
    int parts = dashed ? DASHES : 1;
    for (int i = 0; i < parts; i++) {
      Vector3f from = a.lerp(b, (float) i / parts, new Vector3f());
      Vector3f to = a.lerp(b, (i + (dashed ? 0.55f : 1)) / parts, new Vector3f());
      lines.from(from.x, from.y, from.z, rgb, 1).to(to.x, to.y, to.z, rgb, 1);
    }
  }

  private static Vector3f at(Matrix4f frame, double x, double y, double z) {
    return frame.transformPosition(new Vector3f((float) x, (float) y, (float) z));
  }

  /** The circle that a joint turns on: its middle, and where its position is 0 and a quarter. */
  private record JointCircle(Vector3f middle, Vector3f zero, Vector3f quarter) {
    private static final float BASE_SHARE = 0.3f;

    static JointCircle of(SceneModel model, int joint) {
      if (joint == 0) {
        float height = BASE_SHARE * (float) model.arm().dh().d1();
        return new JointCircle(
            new Vector3f(0, 0, height), new Vector3f(1, 0, 0), new Vector3f(0, 1, 0));
      }
      double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
      model.kinematics().frames(model.positionRad().toArray(), frames);
      double[] t = frames[joint - 1];
      // The x axes of these two point from the far end of the link to the near one.
      float along = joint < WRIST ? -1 : 1;
      return new JointCircle(
          new Vector3f((float) t[9], (float) t[10], (float) t[11]),
          new Vector3f((float) t[0], (float) t[3], (float) t[6]).mul(along),
          new Vector3f((float) t[1], (float) t[4], (float) t[7]).mul(along));
    }

    Vector3f at(double radius, double angleRad) {
      return new Vector3f(middle)
          .fma((float) (radius * Math.cos(angleRad)), zero)
          .fma((float) (radius * Math.sin(angleRad)), quarter);
    }
  }
}
