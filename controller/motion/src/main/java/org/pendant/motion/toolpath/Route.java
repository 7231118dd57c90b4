package org.pendant.motion.toolpath;

import static org.pendant.motion.toolpath.ToolpathTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.nc.NcPoint;

/**
 * Leg planner: makes legs of queued motions. A tool that is free to turn about its z-axis is not
 * turned about it at all here, only its axis follows what was asked for.
 */
final class Route {
  /** Legs of one run. */
  static final int MAX_LEGS = 120_000;

  private static final double NOTHING_M = 1e-9;

  private final boolean turnFree;
  private final List<Leg> legs = new ArrayList<>();
  private Pose at;

  /**
   * A route.
   *
   * @param from where the tool is, in the work frame
   */
  Route(Pose from, boolean turnFree) {
    at = from;
    this.turnFree = turnFree;
  }

  List<Leg> legs() {
    return legs;
  }

  /** Where it ends, in the work frame. */
  Pose end() {
    return at;
  }

  /**
   * Continues with a motion.
   *
   * @throws PlanningException when there is no such way, or there are too many
   */
  void add(QueuedMotion queuedMotion, int id) throws PlanningException {
    String name = text("motion", id);
    switch (queuedMotion) {
      case QueuedMotion.Line line -> line(line.to(), line.pace(), name);
      case QueuedMotion.Arc arc -> arc(arc, name);
      case QueuedMotion.Path path -> path(path, name);
    }
  }

  private void path(QueuedMotion.Path order, String name) throws PlanningException {
    List<NcPoint> points = order.path().points();
    for (int i = 0; i < points.size(); i++) {
      NcPoint point = points.get(i);
      Leg.Limits whole = order.pace();
      boolean last = i + 1 == points.size();
      double speed = order.feeds() ? point.feedMPerS() : whole.speedMPerS();
      Leg.Limits pace = new Leg.Limits(whole.accelerationMPerS2(), speed, whole.radiusM(), !last);
      line(
          Poses.trans(order.pcs(), point.inPart()),
          pace,
          name + " (" + order.path().file() + ":" + point.line() + ")");
    }
  }

  private void line(Pose wanted, Leg.Limits pace, String name) throws PlanningException {
    Pose to = turnFree ? unturned(wanted) : wanted;
    StraightLine line = new StraightLine(at, to);
    double length = Math.max(line.lengthM(), Chaining.MIN_M_PER_RAD * line.angleRad());
    if (length > NOTHING_M) {
      at = to;
      add(new Leg(new LineSegment(line, length), length, pace, name));
    }
  }

  private void arc(QueuedMotion.Arc order, String name) throws PlanningException {
    Pose to = turnFree ? unturned(order.to()) : order.to();
    Optional<ArcSegment> found = ArcSegment.through(at, order.via(), to, order.withTangent());
    if (found.isPresent()) {
      ArcSegment arc = found.get();
      double length = Math.max(arc.arcM(), Chaining.MIN_M_PER_RAD * arc.turnRad());
      add(new Leg(arc.over(length), length, order.pace(), name));
      at = arc.end();
      return;
    }
    double there = Poses.pointDistance(at, order.via());
    double on = Poses.pointDistance(order.via(), to);
    double whole = Poses.pointDistance(at, to);
    if (there + on > whole * (1 + 1e-6) || whole <= NOTHING_M) {
      throw new PlanningException(
          "no-arc", text("noArc", name, place(at), place(order.via()), place(to)));
    }
    line(
        order.withTangent() ? to.with(3, at.rx()).with(4, at.ry()).with(5, at.rz()) : to,
        order.pace(),
        name);
  }

  private static String place(Pose pose) {
    return String.format(Locale.ROOT, "[%.4f, %.4f, %.4f]", pose.x(), pose.y(), pose.z());
  }

  private void add(Leg leg) throws PlanningException {
    if (legs.size() == MAX_LEGS) {
      throw new PlanningException("toolpath-too-long", text("tooLong", leg.name(), MAX_LEGS));
    }
    legs.add(leg);
  }

  /** A pose with the same z-axis that is reached from here without turning about it. */
  private Pose unturned(Pose wanted) {
    double[] now = new double[Transforms.SIZE];
    double[] goal = new double[Transforms.SIZE];
    Transforms.of(at, now);
    Transforms.of(wanted, goal);
    double x = now[5] * goal[8] - now[8] * goal[5];
    double y = now[8] * goal[2] - now[2] * goal[8];
    double z = now[2] * goal[5] - now[5] * goal[2];
    double sine = Math.sqrt(x * x + y * y + z * z);
    double cosine = now[2] * goal[2] + now[5] * goal[5] + now[8] * goal[8];
    double angle = Math.atan2(sine, cosine);
    if (sine < NOTHING_M && cosine < 0) {
      // turned over: any axis across the z-axis will do
      return placed(wanted, now, now[0] * Math.PI, now[3] * Math.PI, now[6] * Math.PI);
    }
    double f = sine < NOTHING_M ? 1 : angle / sine;
    return placed(wanted, now, f * x, f * y, f * z);
  }

  private static Pose placed(Pose place, double[] now, double rx, double ry, double rz) {
    double[] turn = new double[Transforms.SIZE];
    double[] turned = new double[Transforms.SIZE];
    Rotations.vectorToMatrix(rx, ry, rz, turn);
    Transforms.multiply(turn, now, turned);
    Pose pose = Transforms.toPose(turned);
    return new Pose(place.x(), place.y(), place.z(), pose.rx(), pose.ry(), pose.rz());
  }
}
