package org.pendant.controller.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.motion.profile.Profile;
import org.pendant.controller.motion.profile.ProfileLimits;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;

/**
 * Makes motions of moves, and joins each with the one before it.
 *
 * <p>Where a move has a blend radius r, the next may take over where its path enters the sphere of
 * that radius around its goal. From the speeds v there, the blend takes {@code 2 d / v} seconds, d
 * being the way that is left to the goal, and comes out on the next path as far behind the goal as
 * its speed there demands: for two straight lines that is a parabola. What the blend needs in
 * acceleration bounds the speed in which the sphere is entered. If nobody takes over the arm comes
 * to rest at the goal.
 */
final class MovePlanner {
  /** The shortest run-up before a blend, as part of the way. */
  private static final double RUN_UP = 0.1;

  private MovePlanner() {}

  /** A move from rest to rest that nothing blends with. */
  static PathMotion alone(MotionPath path, MoveLimits limits) {
    Move move = new Move(from -> path, limits, 0, 0);
    return PathMotion.to(path, 0, move.restToRest(path), move);
  }

  /** The motion of a move that begins at rest. */
  static PathMotion fromRest(Move move, Joints from, List<Move> outlook) throws ScriptError {
    MotionPath path = move.route().from(from);
    return along(path, 0, 0, move, path.lengthWithinEnd(move.blendRadiusM()), outlook);
  }

  /**
   * The motion of a move that takes over from another.
   *
   * @param leaving the other one
   * @param leavingS where it is, s in its own time, not behind its hand-over
   * @return empty if the move is left out because the blends overlap (manual 15.29)
   */
  static Optional<Motion> blended(
      PathMotion leaving, double leavingS, Move move, List<Move> outlook) throws ScriptError {
    MotionPath before = leaving.path();
    MotionPath after = move.route().from(endOf(before));
    if (after.length() == 0) {
      return Optional.of(new RestOfMove(leaving, leavingS, move.blendRadiusM() > 0));
    }
    double left = before.length() - leaving.handOverAt();
    Optional<ProcessCorner> corner =
        ProcessCorner.between(before, leaving.move(), left, after, move);
    if (corner.isPresent()) {
      Optional<Motion> rounded = corner.get().join(leaving, leavingS, outlook);
      if (rounded.isPresent()) {
        return rounded;
      }
    }
    Blend blend = new Blend(leaving, after, move);
    if (blend.overlaps() && move.leftOutOnOverlap()) {
      return Optional.empty();
    }
    return Optional.of(blend.join(leavingS, outlook));
  }

  /** Joint positions at the end of a path. */
  static Joints endOf(MotionPath path) throws ScriptError {
    MotionSample end = new MotionSample();
    Optional<MotionFailure> failure = path.sample(path.length(), 0, 0, end);
    if (failure.isPresent()) {
      throw new ScriptError(failure.get().code(), failure.get().message());
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
      throws ScriptError {
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
    double to =
        Math.min(
            limits.fastestEnd(path.length() - left - begin, rate),
            Corner.entryRate(path, left, limits, move, outlook));
    if (!(to > 0)) {
      return PathMotion.to(
          path, begin, move.limits(path, 1).between(path.length() - begin, rate, 0), move);
    }
    Profile approach = limits.between(path.length() - left - begin, rate, to);
    Profile settling = limits.withSpeed(to).between(left, to, 0);
    return PathMotion.blending(path, begin, approach, settling, move);
  }
}
