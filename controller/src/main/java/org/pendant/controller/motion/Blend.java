package org.pendant.controller.motion;

import java.util.List;
import java.util.Optional;
import java.util.function.DoublePredicate;
import org.pendant.controller.motion.profile.ProfileLimits;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * How one path is left and the next one entered near the waypoint between them. Between two
 * straight lines of the same TCP the blend runs through tool space, otherwise through joint space.
 */
final class Blend {
  private static final int N = Joints.COUNT;
  private static final int HALVINGS = 40;

  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-9;

  private final PathMotion leaving;
  private final MotionPath before;
  private final MotionPath after;
  private final Move move;

  /** The way left on the first path where it is left, and how fast it goes there. */
  private final double left;

  private final double rate;

  /** How long the blend takes, s. */
  private final double lastsS;

  /** How far behind the waypoint the blend may end, and before the goal the next may begin. */
  private final double mostEntered;

  private final double nextLeft;
  private final boolean overlaps;

  private final double[] directionBefore = new double[N];
  private final double[] directionAfter = new double[N];

  /** Joint accelerations that the two moves themselves use here, rad/s². */
  private final double[] allowed = new double[N];

  Blend(PathMotion leaving, MotionPath after, Move move) throws ScriptError {
    this.leaving = leaving;
    this.after = after;
    this.move = move;
    before = leaving.path();
    left = before.length() - leaving.handOverAt();
    rate = leaving.handOverRate();
    lastsS = 2 * left / rate;
    double entered = after.lengthWithinBegin(leaving.move().blendRadiusM());
    double ending = move.blendRadiusM() > 0 ? after.lengthWithinEnd(move.blendRadiusM()) : 0;
    overlaps = entered + ending > after.length();
    double share = overlaps ? after.length() / (entered + ending) : 1;
    mostEntered = share * entered;
    nextLeft = share * ending;
    direction(before, leaving.handOverAt(), directionBefore);
    direction(after, 0, directionAfter);
  }

  /** Joint speeds for a rate of 1. */
  private static void direction(MotionPath path, double at, double[] speeds) throws ScriptError {
    MotionSample sample = sampled(path, at, 1);
    System.arraycopy(sample.speed, 0, speeds, 0, N);
  }

  private static MotionSample sampled(MotionPath path, double at, double rate) throws ScriptError {
    MotionSample sample = new MotionSample();
    Optional<MotionFailure> failure = path.sample(at, rate, 0, sample);
    if (failure.isPresent()) {
      throw new ScriptError(failure.get().code(), failure.get().message());
    }
    return sample;
  }

  /** Whether the blends at both ends of the new path take more than it has. */
  boolean overlaps() {
    return overlaps;
  }

  /**
   * The rest of the first move, the blend, and the new move.
   *
   * @param leavingS where the first move is, s in its own time
   */
  Motion join(double leavingS, List<Move> outlook) throws ScriptError {
    double entry = entryRate(outlook);
    double entered = Math.min(mostEntered, 0.5 * entry * lastsS);
    Motion blend = sameTool() ? throughToolSpace(entered, entry) : throughJoints(entered, entry);
    PathMotion rest = MovePlanner.along(after, entered, entry, move, nextLeft, outlook);
    return new JoinedMotion(leaving, leavingS, blend, rest);
  }

  private boolean sameTool() {
    return before instanceof ToolPath
        && after instanceof ToolPath
        && before.tcpInFlange().equals(after.tcpInFlange());
  }

  /** The highest rate on the new path that the blend can come out with. */
  private double entryRate(List<Move> outlook) throws ScriptError {
    ProfileLimits limits = move.limits(after, move.blendRadiusM() > 0 ? 0 : 1);
    double strongest = Math.max(limits.acceleration(), leavingAcceleration());
    for (int i = 0; i < N; i++) {
      allowed[i] =
          Math.max(
              Math.abs(directionBefore[i]) * leavingAcceleration(),
              Math.abs(directionAfter[i]) * limits.acceleration());
    }
    double end =
        move.blendRadiusM() > 0 ? Corner.entryRate(after, nextLeft, limits, move, outlook) : 0;
    double most = Math.min(limits.speed(), 2 * mostEntered / lastsS);
    double gentlest = gentlest(most, strongest);
    double bent = highest(gentlest, most, entry -> bend(entry, strongest) <= ROUNDING);
    double slow = highest(0, bent, entry -> slowsDown(entry, end, limits));
    // where the arm comes too fast for both, it rather brakes harder behind the corner
    return bend(slow, strongest) <= ROUNDING ? slow : Math.max(slow, gentlest);
  }

  /** The rate on the new path that needs the least acceleration in the blend. */
  private double gentlest(double most, double strongest) {
    double low = 0;
    double high = most;
    for (int i = 0; i < HALVINGS; i++) {
      double third = (high - low) / 3;
      if (bend(low + third, strongest) <= bend(high - third, strongest)) {
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

  private boolean slowsDown(double entry, double end, ProfileLimits limits) {
    double free = after.length() - nextLeft - 0.5 * entry * lastsS;
    return free >= 0 && entry <= limits.fastestBegin(free, Math.min(end, entry)) * ROUNDING;
  }

  private double leavingAcceleration() {
    return leaving.move().limits(before, 1).acceleration();
  }

  /**
   * The acceleration that the blend needs when it ends with a rate, as a share of what the moves
   * themselves may use; convex in the rate.
   */
  private double bend(double entry, double strongest) {
    double peak = Math.max(move.peakOverMean(), leaving.move().peakOverMean()) / lastsS;
    return peak * (sameTool() ? toolStep(entry) / strongest : jointStep(entry));
  }

  /** By how much the blend changes the tool's velocity, m/s; turning counts as on a path. */
  private double toolStep(double entry) {
    return rate * ((ToolPath) before).bendInto((ToolPath) after, entry / rate);
  }

  /** By how much it changes the speeds of the joints, each as a share of what it may per second. */
  private double jointStep(double entry) {
    double largest = 0;
    for (int i = 0; i < N; i++) {
      double step = Math.abs(entry * directionAfter[i] - rate * directionBefore[i]);
      if (step > 0) {
        largest = Math.max(largest, step / allowed[i]);
      }
    }
    return largest;
  }

  private Motion throughJoints(double entered, double entry) throws ScriptError {
    MotionSample from = sampled(before, leaving.handOverAt(), rate);
    MotionSample to = sampled(after, entered, entry);
    return JointBlend.between(from, to, lastsS, move.smooth(), after.waypoint());
  }

  /** A corner of two lines: positions and turns in it are relative to the waypoint. */
  private Motion throughToolSpace(double entered, double entry) {
    Pose corner = before.waypoint();
    double[] from = new double[Pose.SIZE];
    double[] fromSpeed = new double[Pose.SIZE];
    double[] to = new double[Pose.SIZE];
    double[] toSpeed = new double[Pose.SIZE];
    place(((ToolPath) before).line().at(leaving.handOverAt() / before.length()), corner, from);
    place(((ToolPath) after).line().at(entered / after.length()), corner, to);
    for (int i = 0; i < Pose.SIZE; i++) {
      double start = i < 3 ? corner.get(i) : 0;
      fromSpeed[i] = (start - from[i]) * rate / left;
      toSpeed[i] = entered == 0 ? 0 : (to[i] - start) * entry / entered;
    }
    Hermite way = Hermite.of(from, fromSpeed, to, toSpeed, lastsS, move.smooth());
    ToolPathFollower follower =
        new ToolPathFollower(
            ((ToolPath) before).arm(),
            new ToolBlend(way, corner),
            before.tcpInFlange(),
            after.begin());
    return new ToolBlendMotion(follower, lastsS, after.waypoint());
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
