package org.pendant.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Corner speed: how fast a waypoint may be approached when it is known how the path continues after
 * it: what the blend there can take up, and slow enough for the arm to keep to all the corners that
 * follow and to come to rest at the end. Where that takes longer than a stop the arm slows down to
 * one instead, and so it does between paths of different kinds or of different TCPs: there the next
 * move begins before the first one rests ({@link Overlap}).
 */
final class Corner {
  /** What going through a corner may cost over a stop there, s; rounding aside. */
  private static final double MAX_LOST_S = 1e-9;

  /** Room for rounding in comparisons of rates. */
  private static final double ROUNDING = 1 + 1e-6;

  private final Start start;
  private final MotionPath after;
  private final double left;
  private final ProfileLimits limits;
  private final Move move;
  private final Move next;
  private final Blend blend;
  private final NextSegment nextSegment;

  /** Where a move begins that leads to a corner, and how fast. */
  record Start(MotionPath path, double at, double rate) {
    /** The fastest law that ends in the waypoint at rest. */
    Profile toRest(Move move) {
      return at == 0 && rate == 0
          ? move.restToRest(path)
          : move.limits(path, 1).between(path.length() - at, rate, 0);
    }

    boolean canRest(ProfileLimits limits) {
      return rate <= limits.fastestBegin(path.length() - at, 0) * ROUNDING;
    }
  }

  /**
   * How a corner is approached.
   *
   * @param rate the highest where the next move may take over
   * @param rests whether it is quicker, or as well, to slow down to rest in the waypoint
   */
  record Approach(double rate, boolean rests) {}

  private Corner(
      Start start,
      double left,
      ProfileLimits limits,
      Move move,
      MotionPath after,
      Move next,
      List<Move> further) {
    this.start = start;
    this.left = left;
    this.limits = limits;
    this.move = move;
    this.after = after;
    this.next = next;
    blend = new Blend(start.path, left, move, after, next);
    nextSegment = new NextSegment(after, next, blend.nextLeft(), further);
  }

  /** Whether the next move leads nowhere, or motion version 1 will not make it. */
  private boolean leavesNextOut() {
    return after.length() == 0
        ? next.blendRadiusM() > 0
        : blend.overlaps() && next.leftOutOnOverlap();
  }

  /**
   * The highest rate at which a path may be left for the next one.
   *
   * @param left how far before the end of {@code path} the next move may take over
   * @param limits of the move on {@code path}
   * @param outlook the moves that follow, as far as is known
   */
  static double entryRate(
      MotionPath path, double left, ProfileLimits limits, Move move, List<Move> outlook)
      throws PlanningException {
    Approach approach = approach(new Start(path, 0, 0), left, limits, move, outlook);
    return approach.rests ? limits.fastestBegin(left, 0) : approach.rate;
  }

  /** How a corner is approached by a move that begins somewhere on its path. */
  static Approach approach(
      Start start, double left, ProfileLimits limits, Move move, List<Move> outlook)
      throws PlanningException {
    double anyway = whateverComes(left, limits, move);
    boolean wrench = start.path.pathLimits().limitsWrench();
    for (int i = 0; i < outlook.size(); i++) {
      Move next = outlook.get(i);
      if (!next.mayFollow(move)) {
        return new Approach(0, true);
      }
      List<Move> further = outlook.subList(i + 1, outlook.size());
      MotionPath after = next.route().from(start.path.end());
      Optional<ProcessCorner> round =
          ProcessCorner.between(start.path, move, left, after, next, further);
      if (round.isPresent()) {
        return round.get().approach(start, limits);
      }
      if (wrench) {
        return new Approach(0, true);
      }
      Corner corner = new Corner(start, left, limits, move, after, next, further);
      if (!corner.leavesNextOut()) {
        return corner.approach(anyway);
      }
    }
    return new Approach(anyway, wrench && start.canRest(limits));
  }

  private Approach approach(double anyway) throws PlanningException {
    if (!blend.alike() || after.length() == 0) {
      return new Approach(0, true);
    }
    double rate = Math.max(anyway, known());
    return new Approach(rate, !quicker(rate));
  }

  /** Whether a way through takes no longer than a stop; a duration asked for is kept anyway. */
  private boolean quicker(double highest) throws PlanningException {
    if (!start.canRest(limits) || move.limits().timed() || next.limits().timed()) {
      return true;
    }
    double way = start.path.length() - left - start.at;
    double rate = Math.min(highest, limits.fastestEnd(way, start.rate));
    if (rate >= limits.fastestBegin(left, 0)) {
      // a stop would take longer to the waypoint than the whole blend does
      return true;
    }
    double exit = blend.exit(rate, nextSegment);
    double throughS =
        limits.between(way, start.rate, rate).durationS() - blend.gainedS(rate, exit, nextSegment);
    return throughS <= start.toRest(move).durationS() + MAX_LOST_S;
  }

  /** The rate that every next move can be blended from; without one the arm can stop. */
  private static double whateverComes(double left, ProfileLimits limits, Move move) {
    double anyCorner = new Bend(move.jerkRampS()).highestRate(left, 2 / limits.acceleration());
    return Math.min(anyCorner, limits.fastestBegin(left, 0));
  }

  private double known() throws PlanningException {
    double most = limits.speed();
    ProfileLimits on = nextSegment.limits();
    double keeps = Math.min(1, Math.min(on.speed() / most, blend.mostEntered() / left));
    double bend = bend(keeps, on.acceleration());
    if (bend > 0) {
      most = Math.min(most, Bend.between(move, next).highestRate(left, bend));
    }
    double free = after.length() - blend.mostEntered() - blend.nextLeft();
    if (blend.nextLeft() == 0 || on.fastestBegin(free, 0) >= keeps * most) {
      return Math.min(most, on.fastestBegin(free, 0) / keeps);
    }
    // only now what comes later makes a difference
    return Math.min(most, on.fastestBegin(free, nextSegment.end()) / keeps);
  }

  /**
   * By how much the direction changes when {@code keeps} of the rate is left after the corner, as a
   * share of the acceleration that the blend may have.
   */
  private double bend(double keeps, double onwardAcceleration) {
    double given = limits.acceleration();
    if (start.path instanceof ToolPath line && after instanceof ToolPath on) {
      return line.bendInto(on, keeps) / Math.max(given, onwardAcceleration);
    }
    double largest = 0;
    Joints was = ((JointLine) start.path).direction();
    Joints will = ((JointLine) after).direction();
    for (int i = 0; i < Joints.COUNT; i++) {
      double change = Math.abs(keeps * will.get(i) - was.get(i));
      double allowed =
          Math.max(Math.abs(was.get(i)) * given, Math.abs(will.get(i)) * onwardAcceleration);
      if (change > 0) {
        largest = Math.max(largest, change / allowed);
      }
    }
    return largest;
  }
}
