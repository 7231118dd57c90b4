package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Motion along a path: a time law from any point of the path to its end, where it rests. One with a
 * blend radius may be taken over by the next move. Either it has two laws, up to there and from
 * there on, which is what happens when none takes over; or one that leads to rest anyway, to which
 * the next move adds its own.
 */
public final class PathMotion implements Motion {
  private final MotionPath path;
  private final double begin;
  private final Profile approach;
  private final Optional<Profile> settling;
  private final Move move;
  private final double handOverS;

  /** Whether another move may take over. */
  private final boolean open;

  /** Whether what follows the hand-over keeps to the limits of the move. */
  private final boolean canRest;

  private PathMotion(
      MotionPath path,
      double begin,
      Profile approach,
      Optional<Profile> settling,
      Move move,
      double handOverS,
      boolean open,
      boolean canRest) {
    this.path = path;
    this.begin = begin;
    this.approach = approach;
    this.settling = settling;
    this.move = move;
    this.handOverS = handOverS;
    this.open = open;
    this.canRest = canRest;
  }

  /** A motion that ends in its waypoint. */
  static PathMotion to(MotionPath path, double begin, Profile law, Move move) {
    return new PathMotion(path, begin, law, Optional.empty(), move, law.durationS(), false, true);
  }

  /**
   * A motion that comes to rest in its waypoint, and that another may add to before.
   *
   * @param left how far before the end of the path
   */
  static PathMotion resting(MotionPath path, double begin, Profile law, double left, Move move) {
    double atS = law.timeAt(path.length() - begin - left);
    return new PathMotion(path, begin, law, Optional.empty(), move, atS, true, true);
  }

  /**
   * A motion that another may take over.
   *
   * @param approach up to there
   * @param settling from there to rest in the waypoint
   * @param canRest whether that keeps to the limits of the move
   */
  static PathMotion blending(
      MotionPath path,
      double begin,
      Profile approach,
      Profile settling,
      Move move,
      boolean canRest) {
    return new PathMotion(
        path, begin, approach, Optional.of(settling), move, approach.durationS(), true, canRest);
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
    return begin + (settling.isPresent() ? approach.distance() : approach.position(handOverS));
  }

  /** The rate there. */
  double handOverRate() {
    return approach.speed(handOverS);
  }

  /** Whether it rests in its waypoint as gently as its move does, when no other takes over. */
  boolean canRest() {
    return canRest;
  }

  /** Whether it slows down to rest whatever comes, so that the next move can only add to it. */
  boolean rests() {
    return settling.isEmpty();
  }

  /** How long it takes from the hand-over until it rests, s. */
  double restS() {
    return durationS() - handOverS;
  }

  /** When it is so far from its start on its path, s; no later than the hand-over. */
  double timeAt(double distance) {
    return Math.min(approach.timeAt(distance), handOverS);
  }

  @Override
  public double durationS() {
    return approach.durationS() + (settling.isPresent() ? settling.get().durationS() : 0);
  }

  @Override
  public double handOverS() {
    return handOverS;
  }

  @Override
  public Optional<PathMotion> leaving() {
    return open ? Optional.of(this) : Optional.empty();
  }

  @Override
  public double stretchedS() {
    return move.stretchedS(path);
  }

  @Override
  public Optional<Motion> cutShort(double timeS) {
    double rate = approach.speed(timeS);
    if (!open || !(rate > 0)) {
      return Optional.empty();
    }
    double at = begin + approach.position(timeS);
    ProfileLimits limits = move.limits(path, 1);
    double forAnyCorner = new Bend(move.jerkRampS()).shortestLeft(rate, 2 / limits.acceleration());
    double left = Math.min(forAnyCorner, path.length() - at);
    Optional<MotionPath> shorter = path.upTo(at + left);
    if (shorter.isEmpty() || !(left > 0)) {
      return Optional.empty();
    }
    Profile handedOver = limits.between(0, rate, rate);
    Profile last = limits.withSpeed(rate).between(left, rate, 0);
    boolean gentle = rate <= limits.fastestBegin(left, 0);
    MoveLimits asBefore = new MoveLimits(limits.acceleration(), limits.speed(), 0);
    Move toThere = new Move(from -> path, asBefore, move.blendRadiusM(), move.jerkRampS());
    return Optional.of(blending(shorter.get(), at, handedOver, last, toThere, gentle));
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

  /**
   * What the joints need at most and at least in a part of the time, its direction taken from the
   * middle of it.
   *
   * @param point overwritten by the middle
   * @param highest six accelerations, rad/s², overwritten
   * @param lowest the same
   * @return whether there is such a point
   */
  boolean accelerations(
      double fromS, double toS, MotionSample point, double[] highest, double[] lowest) {
    double middleS = 0.5 * (fromS + toS);
    double settledS = approach.durationS();
    boolean settles = settling.isPresent() && middleS >= settledS;
    Profile law = settles ? settling.get() : approach;
    double lawS = settles ? settledS : 0;
    double at = (settles ? handOverAt() : begin) + law.position(middleS - lawS);
    if (path.sample(at, 1, 0, point).isPresent()) {
      return false;
    }
    double rate = law.speed(middleS - lawS);
    double most = law.extremeAcceleration(fromS - lawS, toS - lawS, 1);
    double least = law.extremeAcceleration(fromS - lawS, toS - lawS, -1);
    for (int i = 0; i < highest.length; i++) {
      double bent = point.acceleration[i] * rate * rate;
      double along = point.speed[i];
      highest[i] = bent + Math.max(along * most, along * least);
      lowest[i] = bent + Math.min(along * most, along * least);
    }
    return true;
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(path.waypoint());
  }
}
