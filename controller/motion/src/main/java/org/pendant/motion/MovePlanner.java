package org.pendant.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Move planner: makes motions of moves, and joins each with the one before it.
 *
 * <p>Where a move has a blend radius r, the next may take over where its path enters the sphere of
 * that radius around its goal. From the speeds v there, the blend takes {@code 2 d / v} seconds, d
 * being the way that is left to the goal, and comes out on the next path as far after the goal as
 * its speed there demands: for two straight lines that is a parabola. What the blend needs in
 * acceleration bounds the speed in which the sphere is entered. Between paths of different kinds,
 * and where a stop is quicker than that, the first move slows down to rest instead, and the next
 * begins before it does. If no move takes over the arm comes to rest at the goal.
 */
final class MovePlanner {
  /** The shortest run-up before a blend, as part of the way. */
  private static final double RUN_UP = 0.1;

  /**
   * By how much a joint may be accelerated more than by either move where moves of different kinds
   * overlap.
   */
  private static final double MAX_OVERLAP_ACCELERATION = 1.4;

  /** A shorter time is not worth sharing, s. */
  private static final double MIN_OVERLAP_S = 0.01;

  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-9;

  private MovePlanner() {}

  /** A move from rest to rest that nothing blends with. */
  static PathMotion alone(MotionPath path, MoveLimits limits) {
    Move move = new Move(from -> path, limits, 0, 0);
    return PathMotion.to(path, 0, move.restToRest(path), move);
  }

  /** The motion of a move that begins at rest. */
  static PathMotion fromRest(Move move, Joints from, List<Move> outlook) throws PlanningException {
    MotionPath path = move.route().from(from);
    return along(path, 0, 0, move, path.lengthWithinEnd(move.blendRadiusM()), outlook);
  }

  /**
   * The motion of a move that takes over from another.
   *
   * @param leaving the other one
   * @param leavingS where it is, s in its own time, not after its hand-over
   * @return empty if the move is left out because the blends overlap (manual 15.29)
   */
  static Optional<Motion> blended(
      PathMotion leaving, double leavingS, Move move, List<Move> outlook) throws PlanningException {
    MotionPath before = leaving.path();
    MotionPath after = move.route().from(endOf(before));
    if (after.length() == 0) {
      return Optional.of(new RemainderMotion(leaving, leavingS, move.blendRadiusM() > 0));
    }
    double left = before.length() - leaving.handOverAt();
    Optional<ProcessCorner> corner =
        ProcessCorner.between(before, leaving.move(), left, after, move, outlook);
    if (corner.isPresent()) {
      Optional<Motion> rounded = corner.get().join(leaving, leavingS);
      if (rounded.isPresent()) {
        return rounded;
      }
    }
    Blend blend = new Blend(before, left, leaving.move(), after, move);
    if (blend.overlaps() && move.leftOutOnOverlap()) {
      return Optional.empty();
    }
    return Optional.of(
        leaving.rests() || (leaving.canRest() && !blend.alike())
            ? overlapping(leaving, leavingS, blend, after, move, outlook)
            : through(leaving, leavingS, blend, after, move, outlook));
  }

  /** The next move begins before the first one rests. */
  private static Motion overlapping(
      PathMotion first, double firstS, Blend blend, MotionPath after, Move move, List<Move> outlook)
      throws PlanningException {
    PathMotion next = along(after, 0, 0, move, blend.nextLeft(), outlook);
    boolean armsLimit = first.move().limitedByArm(first.path()) || move.limitedByArm(after);
    double factor = blend.alike() || armsLimit ? 1 : MAX_OVERLAP_ACCELERATION;
    boolean lines = first.path() instanceof ToolPath && after instanceof ToolPath;
    boolean wrench = after.pathLimits().limitsWrench();
    double sharedS =
        lines && blend.alike() && !wrench
            ? 0
            : Overlap.longestS(first, next, blend.mostEntered(), factor);
    Overlap both = new Overlap(first, next, sharedS);
    while (sharedS > 0 && wrench && !both.keepsWrench(after.pathLimits())) {
      sharedS = sharedS > MIN_OVERLAP_S ? 0.7 * sharedS : 0;
      both = new Overlap(first, next, sharedS);
    }
    return new JoinedMotion(first, firstS, both, next, sharedS);
  }

  /** The path leads past the waypoint, unless a stop there is quicker. */
  private static Motion through(
      PathMotion first, double firstS, Blend blend, MotionPath after, Move move, List<Move> outlook)
      throws PlanningException {
    NextSegment nextSegment = new NextSegment(after, move, blend.nextLeft(), outlook);
    double rate = first.handOverRate();
    double exit = blend.exit(rate, nextSegment);
    boolean timed = first.move().limits().timed() || move.limits().timed();
    boolean stops =
        first.canRest()
            && !timed
            && (!blend.gentle(rate, exit, nextSegment)
                || first.restS() < -blend.gainedS(rate, exit, nextSegment));
    if (stops) {
      return overlapping(first, firstS, blend, after, move, outlook);
    }
    PathMotion next =
        along(after, blend.entered(rate, exit), exit, move, blend.nextLeft(), outlook);
    return new JoinedMotion(first, firstS, blend.between(rate, exit), next);
  }

  /** Joint positions at the end of a path. */
  static Joints endOf(MotionPath path) throws PlanningException {
    MotionSample end = new MotionSample();
    Optional<MotionFailure> failure = path.sample(path.length(), 0, 0, end);
    if (failure.isPresent()) {
      throw new PlanningException(failure.get());
    }
    return end.positionRad();
  }

  /**
   * The motion along a path.
   *
   * @param begin where on the path
   * @param rate how fast there
   * @param within how far from the end the next move may take over
   * @param outlook the moves that follow, as far as is known
   */
  static PathMotion along(
      MotionPath path, double begin, double rate, Move move, double within, List<Move> outlook)
      throws PlanningException {
    boolean blends = move.blendRadiusM() > 0 && path.length() > begin;
    if (!blends) {
      Profile law =
          begin == 0 && rate == 0
              ? move.restToRest(path)
              : move.limits(path, 1).between(path.length() - begin, rate, 0);
      return PathMotion.to(path, begin, law, move);
    }
    ProfileLimits limits = move.limits(path, rate == 0 ? 1 : 0);
    double runUp = rate == 0 ? RUN_UP * (path.length() - begin) : 0;
    double left = Math.min(within, path.length() - begin - runUp);
    Corner.Start start = new Corner.Start(path, begin, rate);
    Corner.Approach approach = Corner.approach(start, left, limits, move, outlook);
    double way = path.length() - left - begin;
    double to = Math.min(limits.fastestEnd(way, rate), approach.rate());
    if (approach.rests() || !(to > 0)) {
      return PathMotion.resting(path, begin, start.toRest(move), left, move);
    }
    // who comes too fast for the corner does not brake harder before it than the move may
    to = Math.max(to, limits.slowestEnd(way, rate));
    Profile toCorner = limits.between(way, rate, to);
    Profile settling = limits.withSpeed(to).between(left, to, 0);
    boolean canRest = to <= limits.fastestBegin(left, 0) * ROUNDING;
    return PathMotion.blending(path, begin, toCorner, settling, move, canRest);
  }
}
