package org.pendant.motion;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.text.FloatText;

/**
 * Route along an arc through three points (manual 15.28): from where the TCP is, through one point,
 * to another. When the middle one lies on the straight line between the others, so does the path.
 *
 * @param via the middle point, in the base frame; only its position counts
 * @param goal pose of the TCP at the end, in the base frame; only its position counts if the
 *     orientation is fixed
 * @param fixed whether the tool keeps its orientation to the tangent, rather than turning evenly to
 *     that of the goal
 */
public record ArcRoute(
    ArmDescription arm,
    Pose via,
    Pose goal,
    boolean fixed,
    Pose tcpInFlange,
    PathLimits pathLimits) {

  /** Sine of the angle at the start below which three points lie on a line. */
  private static final double ON_A_LINE = 1e-7;

  /** Points nearer than this are one, m. */
  private static final double SAME_M = 1e-9;

  /**
   * The path.
   *
   * @param from joint positions at its start, rad
   * @param start pose of the TCP there, in the base frame
   * @throws PlanningException when no circle leads through the points
   */
  public MotionPath from(Joints from, Pose start) throws PlanningException {
    double[] toVia = Arc.minus(place(via), place(start));
    double[] toGoal = Arc.minus(place(goal), place(start));
    double[] normal = Arc.cross(toVia, toGoal);
    double viaM = Arc.size(toVia);
    double goalM = Arc.size(toGoal);
    double twiceArea = Arc.size(normal);
    if (twiceArea <= ON_A_LINE * viaM * goalM) {
      if (viaM > SAME_M && (Arc.dot(toVia, toGoal) < 0 || viaM > goalM + SAME_M)) {
        throw noCircle(start);
      }
      Pose end = fixed ? turnedLike(start) : goal;
      return new ToolPath(arm, from, start, end, tcpInFlange, pathLimits);
    }
    return circle(from, start, toVia, toGoal, normal);
  }

  private static double[] place(Pose pose) {
    return new double[] {pose.x(), pose.y(), pose.z()};
  }

  private Pose turnedLike(Pose start) {
    return new Pose(goal.x(), goal.y(), goal.z(), start.rx(), start.ry(), start.rz());
  }

  /** The centre follows from both chords, their common normal giving the plane. */
  private MotionPath circle(
      Joints from, Pose start, double[] toVia, double[] toGoal, double[] normal) {
    double area = Arc.dot(normal, normal);
    double a = Arc.dot(toVia, toVia);
    double b = Arc.dot(toGoal, toGoal);
    double[] mixed = new double[3];
    for (int i = 0; i < 3; i++) {
      mixed[i] = (a * toGoal[i] - b * toVia[i]) / (2 * area);
    }
    double[] inwards = Arc.cross(mixed, normal);
    double radius = Arc.size(inwards);
    double across = Math.sqrt(area);
    double[] axis = {normal[0] / across, normal[1] / across, normal[2] / across};
    double[] tangent = Arc.cross(inwards, axis);
    for (int i = 0; i < 3; i++) {
      tangent[i] /= radius;
    }
    Arc arc = Arc.leaving(place(start), tangent, place(goal));
    double turnRad = arc.length() / arc.radius();
    return fixed ? following(from, start, arc, axis, turnRad) : turning(from, start, arc, turnRad);
  }

  private MotionPath turning(Joints from, Pose start, Arc arc, double turnRad) {
    StraightLine turn = new StraightLine(start, goal);
    double length = Math.max(arc.length(), turn.angleRad() / ToolPath.ROTATION_FACTOR);
    ToolArc curve = new ToolArc(arc, arc.length() / length, turn, length);
    double farthest = Math.max(turnRad, turn.angleRad());
    return new ArcPath(arm, from, arc, curve, length, farthest, goal, tcpInFlange, pathLimits);
  }

  private MotionPath following(Joints from, Pose start, Arc arc, double[] axis, double turnRad) {
    // the turn for 1 rad: that for the whole arc may be more than half a turn
    Pose oneRad = new Pose(0, 0, 0, axis[0], axis[1], axis[2]);
    StraightLine turn = new StraightLine(start, Poses.add(oneRad, start));
    ToolArc curve = new ToolArc(arc, 1, turn, arc.radius());
    Pose whole = new Pose(0, 0, 0, turnRad * axis[0], turnRad * axis[1], turnRad * axis[2]);
    Pose turned = Poses.add(whole, start);
    Pose end = new Pose(goal.x(), goal.y(), goal.z(), turned.rx(), turned.ry(), turned.rz());
    return new ArcPath(arm, from, arc, curve, arc.length(), turnRad, end, tcpInFlange, pathLimits);
  }

  private PlanningException noCircle(Pose start) {
    return new PlanningException(
        "no-arc", MotionTexts.text("noCircle", text(start), text(via), text(goal)));
  }

  private static String text(Pose pose) {
    return "("
        + FloatText.of(pose.x())
        + ", "
        + FloatText.of(pose.y())
        + ", "
        + FloatText.of(pose.z())
        + ")";
  }
}
