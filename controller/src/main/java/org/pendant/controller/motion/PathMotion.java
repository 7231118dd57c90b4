package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.controller.motion.profile.Profile;
import org.pendant.controller.motion.profile.ProfileLimits;
import org.pendant.models.pose.Pose;

/**
 * A path with a time law, from any point of the path to its end, where it rests. One with a blend
 * radius has two laws: up to where the next move may take over, and from there on, which is what
 * happens when none does.
 */
public final class PathMotion implements Motion {
  private final MotionPath path;
  private final double begin;
  private final Profile approach;
  private final Optional<Profile> settling;
  private final Move move;

  private PathMotion(
      MotionPath path, double begin, Profile approach, Optional<Profile> settling, Move move) {
    this.path = path;
    this.begin = begin;
    this.approach = approach;
    this.settling = settling;
    this.move = move;
  }

  /** A motion that ends in its waypoint. */
  static PathMotion to(MotionPath path, double begin, Profile law, Move move) {
    return new PathMotion(path, begin, law, Optional.empty(), move);
  }

  /**
   * A motion that another may take over.
   *
   * @param approach up to there
   * @param settling from there to rest in the waypoint
   */
  static PathMotion blending(
      MotionPath path, double begin, Profile approach, Profile settling, Move move) {
    return new PathMotion(path, begin, approach, Optional.of(settling), move);
  }

  MotionPath path() {
    return path;
  }

  /** What was asked for. */
  Move move() {
    return move;
  }

  /** The point of the path where the next move may take over. */
  double handOverAt() {
    return begin + approach.distance();
  }

  /** The rate there. */
  double handOverRate() {
    return approach.endSpeed();
  }

  @Override
  public double durationS() {
    return approach.durationS() + (settling.isPresent() ? settling.get().durationS() : 0);
  }

  @Override
  public double handOverS() {
    return approach.durationS();
  }

  @Override
  public Optional<PathMotion> leaving() {
    return settling.isPresent() ? Optional.of(this) : Optional.empty();
  }

  @Override
  public double stretchedS() {
    return move.stretchedS(path);
  }

  @Override
  public Optional<Motion> cutShort(double timeS) {
    double rate = approach.speed(timeS);
    if (settling.isEmpty() || !(rate > 0)) {
      return Optional.empty();
    }
    double at = begin + approach.position(timeS);
    ProfileLimits limits = move.limits(path, 1);
    double forAnyCorner = move.peakOverMean() * rate * rate / limits.acceleration();
    double left = Math.min(forAnyCorner, path.length() - at);
    Optional<MotionPath> shorter = path.upTo(at + left);
    if (shorter.isEmpty() || !(left > 0)) {
      return Optional.empty();
    }
    Profile handedOver = limits.between(0, rate, rate);
    Profile last = limits.withSpeed(rate).between(left, rate, 0);
    MoveLimits asBefore = new MoveLimits(limits.acceleration(), limits.speed(), 0);
    Move toThere = new Move(from -> path, asBefore, move.blendRadiusM(), move.jerkRampS());
    return Optional.of(blending(shorter.get(), at, handedOver, last, toThere));
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    double rest = timeS - approach.durationS();
    if (rest < 0) {
      return path.sample(
          begin + approach.position(timeS),
          approach.speed(timeS),
          approach.acceleration(timeS),
          sample);
    }
    if (settling.isPresent() && rest < settling.get().durationS()) {
      Profile last = settling.get();
      return path.sample(
          handOverAt() + last.position(rest), last.speed(rest), last.acceleration(rest), sample);
    }
    return path.sample(path.length(), 0, 0, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(path.waypoint());
  }
}
