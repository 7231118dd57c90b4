package org.pendant.controller.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.motion.profile.ProfileLimits;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;

/**
 * How fast a waypoint may be approached when it is known how the path leads on behind it: what the
 * blend there can take up, and slow enough for the arm to keep to all the corners behind and to
 * come to rest at the end. Paths of different kinds, or of different TCPs, cannot be compared; then
 * nothing is gained by knowing.
 */
final class Corner {
  private final MotionPath before;
  private final MotionPath after;
  private final double left;
  private final ProfileLimits limits;
  private final Move move;
  private final Move next;

  /** How much of the next path lies in the sphere of this corner, and of the one after it. */
  private final double entered;

  private final double ending;

  private Corner(MotionPath before, double left, ProfileLimits limits, Move move, Move next)
      throws ScriptError {
    this.before = before;
    this.left = left;
    this.limits = limits;
    this.move = move;
    this.next = next;
    after = next.route().from(before.end());
    entered = after.lengthWithinBegin(move.blendRadiusM());
    ending = next.blendRadiusM() > 0 ? after.lengthWithinEnd(next.blendRadiusM()) : 0;
  }

  /** Whether the next move leads nowhere, or motion version 1 will not make it. */
  private boolean leavesNextOut() {
    boolean overlaps = ending > 0 && entered + ending > after.length();
    return after.length() == 0 ? next.blendRadiusM() > 0 : overlaps && next.leftOutOnOverlap();
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
      throws ScriptError {
    double anyway = whateverComes(left, limits, move);
    for (int i = 0; i < outlook.size(); i++) {
      Move next = outlook.get(i);
      if (!next.mayFollow(move)) {
        return limits.fastestBegin(left, 0);
      }
      Corner corner = new Corner(path, left, limits, move, next);
      Optional<ProcessCorner> round = ProcessCorner.between(path, move, left, corner.after, next);
      if (round.isPresent()) {
        double rate = round.get().entryRate(limits, outlook.subList(i + 1, outlook.size()));
        return rate > 0 ? rate : anyway;
      }
      if (!corner.leavesNextOut()) {
        return Math.max(anyway, corner.known(outlook.subList(i + 1, outlook.size())));
      }
    }
    return anyway;
  }

  /** The rate that every next move can be blended from; without one the arm can stop. */
  private static double whateverComes(double left, ProfileLimits limits, Move move) {
    double anyCorner = Math.sqrt(limits.acceleration() * left / move.peakOverMean());
    return Math.min(anyCorner, limits.fastestBegin(left, 0));
  }

  private double known(List<Move> further) throws ScriptError {
    if (!comparable() || after.length() == 0) {
      return 0;
    }
    double share = Math.min(1, after.length() / (entered + ending));
    ProfileLimits onward = next.limits(after, next.blendRadiusM() > 0 ? 0 : 1);
    double most = limits.speed();
    double keeps = Math.min(1, Math.min(onward.speed() / most, share * entered / left));
    double bend = bend(keeps, onward.acceleration());
    double peak = Math.max(move.peakOverMean(), next.peakOverMean());
    if (bend > 0) {
      most = Math.min(most, Math.sqrt(2 * left / (peak * bend)));
    }
    double free = after.length() - share * (entered + ending);
    if (ending == 0 || onward.fastestBegin(free, 0) >= keeps * most) {
      return Math.min(most, onward.fastestBegin(free, 0) / keeps);
    }
    // only now what comes later makes a difference
    double end = entryRate(after, share * ending, onward, next, further);
    return Math.min(most, onward.fastestBegin(free, end) / keeps);
  }

  private boolean comparable() {
    return (before instanceof JointLine && after instanceof JointLine)
        || (before instanceof ToolPath
            && after instanceof ToolPath
            && before.tcpInFlange().equals(after.tcpInFlange()));
  }

  /**
   * By how much the direction changes when {@code keeps} of the rate is left after the corner, as a
   * share of the acceleration that the blend may have.
   */
  private double bend(double keeps, double onwardAcceleration) {
    double given = limits.acceleration();
    if (before instanceof ToolPath line && after instanceof ToolPath on) {
      return line.bendInto(on, keeps) / Math.max(given, onwardAcceleration);
    }
    double largest = 0;
    Joints was = ((JointLine) before).direction();
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
