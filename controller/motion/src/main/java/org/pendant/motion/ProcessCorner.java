package org.pendant.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Process move corner: how a process move takes over from another tool move: the corner is rounded
 * on a circle that touches both paths, at the speed in which it is reached (manual 15.31). Where
 * one way leads straight into the next there is nothing to round. The arm stops at waypoints where
 * that is quicker, or no circle touches both ways.
 */
final class ProcessCorner {
  /** Change of direction, and of turning in rad/m, that counts as none. */
  private static final double NO_BEND = 1e-6;

  /** Sharper corners than this cannot be rounded: cosine of the angle between both directions. */
  private static final double SHARPEST = -0.999;

  /** Length (m) of the TCP's way for each unit of a path below which the tool turns on the spot. */
  private static final double ON_THE_SPOT = 1e-3;

  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-6;

  /** What rounding a corner may cost over a stop there, s; rounding of numbers aside. */
  private static final double MAX_LOST_S = 1e-9;

  private final ToolCurvePath before;
  private final ToolCurvePath after;
  private final Move leaving;
  private final Move move;

  /** Metres of the TCP for each unit of the paths. */
  private final double metresBefore;

  private final double metresAfter;

  /** Where the circle begins before the waypoint and ends behind it, in units of the paths. */
  private final double endsBefore;

  private final double beginsAfter;
  private final double left;
  private final NextSegment nextSegment;
  private final List<Move> further;
  private final double nextLeft;
  private final Optional<Rounded> rounded;

  /** The highest speed (m/s) on the arc that keeps the tool's wrench. */
  private final double fastestForWrench;

  /** Whether there is a way round; too sharp a corner has none, nor a turn on the spot. */
  private final boolean possible;

  private record Rounded(CornerArc curve, double lengthM, double radiusM, double turningPerM2) {}

  private ProcessCorner(
      ToolCurvePath before,
      ToolCurvePath after,
      Move leaving,
      Move move,
      double left,
      List<Move> further) {
    this.before = before;
    this.after = after;
    this.leaving = leaving;
    this.move = move;
    this.left = left;
    double wrench = Double.POSITIVE_INFINITY;
    double[] was = twist(before, before.length());
    double[] will = twist(after, 0);
    metresBefore = Arc.size(was);
    metresAfter = Arc.size(will);
    double entered = after.lengthWithinBegin(leaving.blendRadiusM());
    double ending = move.blendRadiusM() > 0 ? after.lengthWithinEnd(move.blendRadiusM()) : 0;
    double share = Math.min(1, after.length() / (entered + ending));
    nextLeft = share * ending;
    this.further = further;
    nextSegment = new NextSegment(after, move, nextLeft, further);
    possible = possible(was, will);
    if (!possible || leadsStraightOn(was, will)) {
      endsBefore = 0;
      beginsAfter = 0;
      rounded = Optional.empty();
    } else {
      double most = ending > 0 ? share * entered : Math.min(entered, 0.5 * after.length());
      double away = Math.min(left * metresBefore, most * metresAfter);
      endsBefore = away / metresBefore;
      beginsAfter = away / metresAfter;
      rounded = Optional.of(round());
      wrench = fastestForWrench(after, rounded.get());
    }
    fastestForWrench = wrench;
  }

  /**
   * The corner between two moves.
   *
   * @param left how far before the end of its path the first is left, in the unit of the path
   * @param further the moves after both, as far as is known
   * @return empty if they are no such moves, or of different TCPs
   */
  static Optional<ProcessCorner> between(
      MotionPath before,
      Move leaving,
      double left,
      MotionPath after,
      Move move,
      List<Move> further) {
    if (move.kind() == Move.Kind.PROCESS
        && before instanceof ToolCurvePath from
        && after instanceof ToolCurvePath to
        && from.tcpInFlange().equals(to.tcpInFlange())
        && from.length() > 0
        && to.length() > 0
        && !leaving.limitedByArm(before)) {
      return Optional.of(new ProcessCorner(from, to, leaving, move, left, further));
    }
    return Optional.empty();
  }

  private static double[] twist(ToolCurvePath way, double at) {
    double[] twist = new double[Pose.SIZE];
    way.curve().rate(at, twist);
    return twist;
  }

  private boolean possible(double[] was, double[] will) {
    return metresBefore > ON_THE_SPOT
        && metresAfter > ON_THE_SPOT
        && Arc.dot(was, will) > SHARPEST * metresBefore * metresAfter;
  }

  private boolean leadsStraightOn(double[] was, double[] will) {
    double change = 0;
    for (int i = 0; i < Pose.SIZE; i++) {
      change = Math.max(change, Math.abs(will[i] / metresAfter - was[i] / metresBefore));
    }
    return change < NO_BEND;
  }

  private Rounded round() {
    double leftAt = before.length() - endsBefore;
    double[] from = new double[Transforms.SIZE];
    double[] to = new double[Transforms.SIZE];
    before.curve().at(leftAt, from);
    after.curve().at(beginsAfter, to);
    double[] fromTwist = twist(before, leftAt);
    double[] toTwist = twist(after, beginsAfter);
    Arc[] arcs =
        CornerArc.arcs(
            place(from),
            scaled(fromTwist, 1 / metresBefore),
            place(to),
            scaled(toTwist, 1 / metresAfter));
    double lengthM = arcs[0].length() + arcs[1].length();
    double[] corner = new double[Transforms.SIZE];
    before.curve().at(before.length(), corner);
    Hermite turn =
        Hermite.of(
            turned(corner, from),
            turning(corner, fromTwist, metresBefore),
            turned(corner, to),
            turning(corner, toTwist, metresAfter),
            lengthM,
            false);
    Pose waypoint = Transforms.toPose(corner);
    double radiusM = Math.min(arcs[0].radius(), arcs[1].radius());
    double turningPerM2 = Math.max(strength(turn, 0), strength(turn, lengthM));
    return new Rounded(CornerArc.of(arcs, turn, waypoint), lengthM, radiusM, turningPerM2);
  }

  private static double[] place(double[] transform) {
    return new double[] {transform[9], transform[10], transform[11]};
  }

  private static double[] scaled(double[] v, double f) {
    return new double[] {f * v[0], f * v[1], f * v[2]};
  }

  /** Rotation vector from the corner's orientation to another one, along the axes of the corner. */
  private static double[] turned(double[] corner, double[] to) {
    double[] back = new double[Transforms.SIZE];
    double[] between = new double[Transforms.SIZE];
    double[] vector = new double[3];
    Transforms.invert(corner, back);
    Transforms.multiply(back, to, between);
    Rotations.matrixToVector(between, vector);
    return new double[] {0, 0, 0, vector[0], vector[1], vector[2]};
  }

  /** Turning per metre along the axes of the corner; both ways turn about one axis through it. */
  private static double[] turning(double[] corner, double[] twist, double metres) {
    double[] along = new double[Pose.SIZE];
    for (int i = 0; i < 3; i++) {
      along[3 + i] =
          (corner[i] * twist[3] + corner[3 + i] * twist[4] + corner[6 + i] * twist[5]) / metres;
    }
    return along;
  }

  private static double strength(Hermite turn, double at) {
    double[] place = new double[Pose.SIZE];
    double[] rate = new double[Pose.SIZE];
    double[] bend = new double[Pose.SIZE];
    turn.at(at, place, rate, bend);
    return Math.sqrt(bend[3] * bend[3] + bend[4] * bend[4] + bend[5] * bend[5]);
  }

  /** The highest speed (m/s) on the arc that the limits of the tool's wrench allow. */
  private static double fastestForWrench(ToolCurvePath after, Rounded rounded) {
    return after.pathLimits().limitsWrench()
        ? after
            .pathLimits()
            .along(
                after.arm(), rounded.curve(), rounded.lengthM(), after.tcpInFlange(), after.begin())
            .rate()
        : Double.POSITIVE_INFINITY;
  }

  /** The highest speed (m/s) on the arc for an acceleration (m/s²); turning counts as on a path. */
  private double fastest(double accelerationMPerS2) {
    if (rounded.isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    double across = accelerationMPerS2 * rounded.get().radiusM();
    double turning = ToolPath.ROTATION_FACTOR * accelerationMPerS2 / rounded.get().turningPerM2();
    return Math.min(fastestForWrench, Math.sqrt(Math.min(across, turning)));
  }

  /** The highest speed (m/s), up to a limit, after the corner from which the next can continue. */
  private double fastestOnward(double most) throws PlanningException {
    return nextSegment.fastestBegin(beginsAfter, most / metresAfter) * metresAfter;
  }

  /**
   * How the corner is approached.
   *
   * @param limits of the first move
   */
  Corner.Approach approach(Corner.Start start, ProfileLimits limits) throws PlanningException {
    if (!possible) {
      return new Corner.Approach(0, true);
    }
    double most = fastest(Math.min(limits.acceleration(), nextSegment.limits().acceleration()));
    double speed = fastestOnward(Math.min(limits.speed() * metresBefore, most));
    double highest = speed / metresBefore;
    double way = before.length() - left - start.at();
    double rate = Math.min(highest, limits.fastestEnd(way, start.rate()));
    if (!(rate > 0)) {
      return new Corner.Approach(0, true);
    }
    // at the rate of a stop the waypoint would be reached later than the end of the circle
    boolean quicker =
        rate >= limits.fastestBegin(left, 0)
            || !start.canRest(limits)
            || limits.between(way, start.rate(), rate).durationS() + takesS(rate)
                <= start.toRest(leaving).durationS() + MAX_LOST_S;
    return new Corner.Approach(highest, !quicker);
  }

  /**
   * How long the corner takes, from where the first path may be left, less what the next move then
   * gains over one from rest, s.
   */
  private double takesS(double rate) throws PlanningException {
    double lengthM = rounded.map(Rounded::lengthM).orElse(0.0);
    return (left - endsBefore) / rate
        + lengthM / (rate * metresBefore)
        - nextSegment.gainedS(beginsAfter, rate * metresBefore / metresAfter);
  }

  /**
   * The rest of the first move, the arc or a stop where that is quicker, and the new move.
   *
   * @param first the move under way
   * @param firstS where it is, s in its own time
   * @return empty if the corner is reached too fast for that
   */
  Optional<Motion> join(PathMotion first, double firstS) throws PlanningException {
    double rate = first.handOverRate();
    double speed = rate * metresBefore;
    double strongest =
        Math.max(leaving.limits(before, 1).acceleration(), nextSegment.limits().acceleration());
    boolean tooFast =
        !possible
            || speed > fastest(strongest) * ROUNDING
            || speed > fastestOnward(speed) * ROUNDING;
    if (first.rests() || (first.canRest() && (tooFast || first.restS() < takesS(rate)))) {
      PathMotion anew = MovePlanner.along(after, 0, 0, move, nextLeft, further);
      return Optional.of(new JoinedMotion(first, firstS, new Settling(first), anew));
    }
    if (tooFast) {
      return Optional.empty();
    }
    double straight = before.length() - endsBefore - first.handOverAt();
    CornerMotion corner =
        new CornerMotion(before, first.handOverAt(), straight, rate, after.waypoint());
    if (rounded.isPresent()) {
      ToolPathFollower follower =
          new ToolPathFollower(
              after.arm(), rounded.get().curve(), after.tcpInFlange(), after.begin());
      corner = corner.thenRound(follower, rounded.get().lengthM(), speed);
    }
    PathMotion rest =
        MovePlanner.along(after, beginsAfter, speed / metresAfter, move, nextLeft, further);
    return Optional.of(new JoinedMotion(first, firstS, corner, rest));
  }
}
