package org.pendant.motion;

import java.util.Optional;
import java.util.function.DoublePredicate;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Blend: the curve from one path to the next near the waypoint between them. Between two straight
 * lines of the same TCP the blend runs through tool space, otherwise through joint space.
 */
final class Blend {
  private static final int N = Joints.COUNT;
  private static final int HALVINGS = 40;

  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-9;

  private final MotionPath before;
  private final MotionPath after;
  private final Move leaving;
  private final Move move;

  /** The way left on the first path where it is left. */
  private final double left;

  /** How far after the waypoint the blend may end, and before the goal the next may begin. */
  private final double mostEntered;

  private final double nextLeft;
  private final boolean overlaps;
  private final Bend bend;

  private boolean directionsKnown;
  private final double[] directionBefore = new double[N];
  private final double[] directionAfter = new double[N];

  /** Joint accelerations that the two moves themselves use here, rad/s². */
  private final double[] allowed = new double[N];

  /**
   * A blend.
   *
   * @param left how far before its end the first path may be left
   * @param leaving the move on it
   */
  Blend(MotionPath before, double left, Move leaving, MotionPath after, Move move) {
    this.before = before;
    this.left = left;
    this.leaving = leaving;
    this.after = after;
    this.move = move;
    bend = Bend.between(leaving, move);
    double entered = after.lengthWithinBegin(leaving.blendRadiusM());
    double ending = move.blendRadiusM() > 0 ? after.lengthWithinEnd(move.blendRadiusM()) : 0;
    overlaps = entered + ending > after.length();
    double share = overlaps ? after.length() / (entered + ending) : 1;
    mostEntered = share * entered;
    nextLeft = share * ending;
  }

  /** Joint speeds for a rate of 1. */
  private static void direction(MotionPath path, double at, double[] speeds)
      throws PlanningException {
    MotionSample sample = sampled(path, at, 1);
    System.arraycopy(sample.speed, 0, speeds, 0, N);
  }

  private static MotionSample sampled(MotionPath path, double at, double rate)
      throws PlanningException {
    MotionSample sample = new MotionSample();
    Optional<MotionFailure> failure = path.sample(at, rate, 0, sample);
    if (failure.isPresent()) {
      throw new PlanningException(failure.get());
    }
    return sample;
  }

  /** Whether the blends at both ends of the new path take more than it has. */
  boolean overlaps() {
    return overlaps;
  }

  /** How far after the waypoint it may end. */
  double mostEntered() {
    return mostEntered;
  }

  /** How far before the goal of the new move the one after it may take over. */
  double nextLeft() {
    return nextLeft;
  }

  /** How long it takes when it begins at a rate, s. */
  double lastsS(double rate) {
    return 2 * left / rate;
  }

  /** Where on the new path it ends. */
  double entered(double rate, double exit) {
    return Math.min(mostEntered, 0.5 * exit * lastsS(rate));
  }

  /**
   * How much sooner the new move comes as far than from rest in the waypoint, less the time for the
   * blend itself, s.
   */
  double gainedS(double rate, double exit, NextSegment nextSegment) throws PlanningException {
    return nextSegment.gainedS(entered(rate, exit), exit) - lastsS(rate);
  }

  /** The way from one path to the next. */
  Motion between(double rate, double exit) throws PlanningException {
    double entered = entered(rate, exit);
    return sameTool() ? throughToolSpace(rate, entered, exit) : throughJoints(rate, entered, exit);
  }

  /**
   * Whether both paths are of one kind, so that what the blend needs is known beforehand. A line on
   * which the joints are the limit says nothing about another one.
   */
  boolean alike() {
    return sameTool()
        ? !leaving.limitedByArm(before) && !move.limitedByArm(after)
        : (before instanceof JointLine && after instanceof JointLine);
  }

  private boolean sameTool() {
    return before instanceof ToolPath
        && after instanceof ToolPath
        && before.tcpInFlange().equals(after.tcpInFlange());
  }

  private double strongest(NextSegment nextSegment) {
    return Math.max(nextSegment.limits().acceleration(), leavingAcceleration());
  }

  /** Whether it needs no more acceleration than the moves themselves may use. */
  boolean gentle(double rate, double exit, NextSegment nextSegment) {
    return bend(rate, exit, strongest(nextSegment)) <= ROUNDING;
  }

  /** The highest rate on the new path that the blend can come out with. */
  double exit(double rate, NextSegment nextSegment) throws PlanningException {
    ProfileLimits limits = nextSegment.limits();
    double strongest = strongest(nextSegment);
    if (!sameTool()) {
      findDirections(limits);
    }
    double most = Math.min(limits.speed(), 2 * mostEntered / lastsS(rate));
    double gentlest = gentlest(rate, most, strongest);
    double bent = highest(gentlest, most, exit -> bend(rate, exit, strongest) <= ROUNDING);
    double slow = bent;
    if (!slowsDown(rate, bent, 0, limits)) {
      // only now what comes later makes a difference
      double end = nextSegment.end();
      slow = highest(0, bent, exit -> slowsDown(rate, exit, end, limits));
    }
    // where the arm comes too fast for both, it rather brakes harder after the corner
    return bend(rate, slow, strongest) <= ROUNDING ? slow : Math.max(slow, gentlest);
  }

  private void findDirections(ProfileLimits limits) throws PlanningException {
    if (!directionsKnown) {
      directionsKnown = true;
      direction(before, before.length() - left, directionBefore);
      direction(after, 0, directionAfter);
      for (int i = 0; i < N; i++) {
        allowed[i] =
            Math.max(
                Math.abs(directionBefore[i]) * leavingAcceleration(),
                Math.abs(directionAfter[i]) * limits.acceleration());
      }
    }
  }

  /** The rate on the new path that needs the least acceleration in the blend. */
  private double gentlest(double rate, double most, double strongest) {
    double low = 0;
    double high = most;
    for (int i = 0; i < HALVINGS; i++) {
      double third = (high - low) / 3;
      if (bend(rate, low + third, strongest) <= bend(rate, high - third, strongest)) {
        high -= third;
      } else {
        low += third;
      }
    }
    return low;
  }

  /** The highest rate up to a limit for which something holds that holds for slower ones. */
  private static double highest(double slowest, double limit, DoublePredicate holds) {
    if (holds.test(limit)) {
      return limit;
    }
    double low = slowest;
    double high = limit;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      if (holds.test(middle)) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private boolean slowsDown(double rate, double entry, double end, ProfileLimits limits) {
    double free = after.length() - nextLeft - 0.5 * entry * lastsS(rate);
    return free >= 0 && entry <= limits.fastestBegin(free, Math.min(end, entry)) * ROUNDING;
  }

  private double leavingAcceleration() {
    return leaving.limits(before, 1).acceleration();
  }

  /**
   * The acceleration that the blend needs when it ends with a rate, as a share of what the moves
   * themselves may use; convex in the rate.
   */
  private double bend(double rate, double entry, double strongest) {
    double step = sameTool() ? toolStep(rate, entry) / strongest : jointStep(rate, entry);
    return bend.strength(step, lastsS(rate));
  }

  /** By how much the blend changes the tool's velocity, m/s; turning counts as on a path. */
  private double toolStep(double rate, double entry) {
    return rate * ((ToolPath) before).bendInto((ToolPath) after, entry / rate);
  }

  /** By how much it changes the speeds of the joints, each as a share of what it may per second. */
  private double jointStep(double rate, double entry) {
    double largest = 0;
    for (int i = 0; i < N; i++) {
      double step = Math.abs(entry * directionAfter[i] - rate * directionBefore[i]);
      if (step > 0) {
        largest = Math.max(largest, step / allowed[i]);
      }
    }
    return largest;
  }

  private Motion throughJoints(double rate, double entered, double entry) throws PlanningException {
    MotionSample from = sampled(before, before.length() - left, rate);
    MotionSample to = sampled(after, entered, entry);
    return JointBlend.between(from, to, lastsS(rate), bend.smooth(), after.waypoint());
  }

  /** A corner of two lines: positions and turns in it are relative to the waypoint. */
  private Motion throughToolSpace(double rate, double entered, double entry) {
    Pose corner = before.waypoint();
    double[] from = new double[Pose.SIZE];
    double[] fromSpeed = new double[Pose.SIZE];
    double[] to = new double[Pose.SIZE];
    double[] toSpeed = new double[Pose.SIZE];
    place(((ToolPath) before).line().at(1 - left / before.length()), corner, from);
    place(((ToolPath) after).line().at(entered / after.length()), corner, to);
    for (int i = 0; i < Pose.SIZE; i++) {
      double start = i < 3 ? corner.get(i) : 0;
      fromSpeed[i] = (start - from[i]) * rate / left;
      toSpeed[i] = entered == 0 ? 0 : (to[i] - start) * entry / entered;
    }
    Hermite way = Hermite.of(from, fromSpeed, to, toSpeed, lastsS(rate), bend.smooth());
    ToolPathFollower follower =
        new ToolPathFollower(
            ((ToolPath) before).arm(),
            new ToolBlend(way, corner),
            before.tcpInFlange(),
            after.begin());
    return new ToolBlendMotion(follower, lastsS(rate), after.waypoint());
  }

  /** Position in the base frame, and rotation vector from the corner's orientation, in its axes. */
  private static void place(Pose at, Pose corner, double[] place) {
    Pose turned = Poses.trans(Poses.inverse(corner), at);
    place[0] = at.x();
    place[1] = at.y();
    place[2] = at.z();
    place[3] = turned.rx();
    place[4] = turned.ry();
    place[5] = turned.rz();
  }
}
