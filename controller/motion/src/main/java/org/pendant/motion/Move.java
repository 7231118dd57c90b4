package org.pendant.motion;

import org.pendant.models.arm.Joints;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Move as a program asks for it: where to, how fast, and how near to its goal the next move may
 * take over.
 *
 * @param route the path, once it is known where it begins
 * @param blendRadiusM of the sphere around the goal in which the path may be left, m, 0 or more
 * @param jerkRampS how long the acceleration takes to grow to its limit, s; 0 for at once, as in
 *     motion version 1 (manual 14)
 * @param kind which moves it may blend with
 */
public record Move(
    PathPlanner route, MoveLimits limits, double blendRadiusM, double jerkRampS, Kind kind) {

  /** Moves of different kinds lead round a waypoint in different ways. */
  public enum Kind {
    /** From goal to goal: movej, movel, optimovej and optimovel. */
    TRAVEL,
    /** At an even speed of the tool, round waypoints too: movep and movec. */
    PROCESS
  }

  /** Acceleration that a duration may lead to on a path of joints. Our choice. */
  private static final double TIMED_RAD_PER_S2 = 40;

  /** The same on a path of the TCP. */
  private static final double TIMED_M_PER_S2 = 15;

  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-9;

  /** Makes the path of a move. */
  @FunctionalInterface
  public interface PathPlanner {
    /**
     * The path.
     *
     * @param from joint positions at its start, rad
     * @throws PlanningException when there is none
     */
    MotionPath from(Joints from) throws PlanningException;
  }

  /** A move from goal to goal. */
  public Move(PathPlanner route, MoveLimits limits, double blendRadiusM, double jerkRampS) {
    this(route, limits, blendRadiusM, jerkRampS, Kind.TRAVEL);
  }

  /** Checks the numbers. */
  public Move {
    if (!(blendRadiusM >= 0 && jerkRampS >= 0)) {
      throw new IllegalArgumentException(
          "blend radius is "
              + blendRadiusM
              + ", jerk ramp "
              + jerkRampS
              + ", must not be negative");
    }
  }

  /** Whether it may take over from another move that is under way (manual 15.29, 15.32). */
  boolean mayFollow(Move before) {
    return kind == Kind.PROCESS || before.kind == Kind.TRAVEL;
  }

  /** Whether it is left out rather than made where its blends overlap (manual 15.29). */
  boolean leftOutOnOverlap() {
    return kind == Kind.TRAVEL && !smooth() && blendRadiusM > 0;
  }

  /** Whether acceleration grows and fades rather than jumps. */
  boolean smooth() {
    return jerkRampS > 0;
  }

  /** Whether the arm, rather than the program, decides how fast it is on a path. */
  boolean limitedByArm(MotionPath path) {
    return path.strongestRate2() < limits.acceleration();
  }

  /** The limits on a path, of which {@code restingEnds} ends are at rest. */
  ProfileLimits limits(MotionPath path, int restingEnds) {
    return kept(path, limits.over(path.length(), restingEnds, path.fastestRate(), strongest(path)));
  }

  /** Limits within what the arm has for the path, slow enough for where the path bends. */
  private ProfileLimits kept(MotionPath path, ProfileLimits even) {
    double acceleration = Math.min(even.acceleration(), path.strongestRate2());
    double speed = Math.min(even.speed(), Math.sqrt(acceleration / path.bending()));
    double jerk = smooth() ? acceleration / jerkRampS : Double.POSITIVE_INFINITY;
    return new ProfileLimits(speed, acceleration, jerk);
  }

  private static double strongest(MotionPath path) {
    return path instanceof JointLine ? TIMED_RAD_PER_S2 : TIMED_M_PER_S2;
  }

  /** The law for the whole of a path from rest to rest. */
  Profile restToRest(MotionPath path) {
    double length = path.length();
    ProfileLimits within = limits(path, 2);
    if (length == 0 || !limits.timed()) {
      return within.over(length);
    }
    Profile timed = within.withDuration(length, limits.durationS());
    ProfileLimits most = quickest(path);
    if (timed.peakSpeed() <= most.speed() && timed.peakAcceleration() <= most.acceleration()) {
      return timed;
    }
    Profile quickest = most.over(length);
    return quickest.durationS() < limits.durationS()
        ? most.withDuration(length, limits.durationS())
        : quickest;
  }

  /** The most that is made of a duration. */
  private ProfileLimits quickest(MotionPath path) {
    double speed = Math.min(path.fastestRate(), Double.MAX_VALUE);
    return kept(path, ProfileLimits.of(speed, Math.max(limits.acceleration(), strongest(path))));
  }

  /** How long the whole path takes if that is more than was asked for, s; otherwise 0. */
  double stretchedS(MotionPath path) {
    double leastS = limits.timed() ? quickest(path).over(path.length()).durationS() : 0;
    return leastS > limits.durationS() * ROUNDING ? leastS : 0;
  }
}
