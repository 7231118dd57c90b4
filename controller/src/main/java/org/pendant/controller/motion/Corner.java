package org.pendant.controller.motion;

import java.util.List;
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

  private Corner(MotionPath before, double left, ProfileLimits limits, Move move, Move next)
      throws ScriptError {
    this.before = before;
    this.left = left;
    this.limits = limits;
    this.move = move;
    this.next = next;
    after = next.route().from(before.end());
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
    if (outlook.isEmpty()) {
      return anyway;
    }
    Corner corner = new Corner(path, left, limits, move, outlook.getFirst());
    return Math.max(anyway, corner.known(outlook.subList(1, outlook.size())));
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
    double entered = after.lengthWithinBegin(move.blendRadiusM());
    double ending = next.blendRadiusM() > 0 ? after.lengthWithinEnd(next.blendRadiusM()) : 0;
    double share = Math.min(1, after.length() / (entered + ending));
    ProfileLimits onward = next.limits(after, next.blendRadiusM() > 0 ? 0 : 1);
    double most = limits.speed();
    double keeps = Math.min(1, Math.min(onward.speed() / most, share * entered / left));
    double bend = bend(keeps);
    double peak = Math.max(move.peakOverMean(), next.peakOverMean());
    if (bend > 0) {
      most = Math.min(most, Math.sqrt(2 * limits.acceleration() * left / (peak * bend)));
    }
    double end =
        next.blendRadiusM() > 0 ? entryRate(after, share * ending, onward, next, further) : 0;
    double free = after.length() - share * (entered + ending);
    return Math.min(most, onward.fastestBegin(free, end) / keeps);
  }

  private boolean comparable() {
    return (before instanceof JointLine && after instanceof JointLine)
        || (before instanceof ToolPath
            && after instanceof ToolPath
            && before.tcpInFlange().equals(after.tcpInFlange()));
  }

  /** By how much the direction changes when {@code keeps} of the rate is left after the corner. */
  private double bend(double keeps) {
    if (before instanceof ToolPath line && after instanceof ToolPath on) {
      return line.bendInto(on, keeps);
    }
    double largest = 0;
    Joints was = ((JointLine) before).direction();
    Joints will = ((JointLine) after).direction();
    for (int i = 0; i < Joints.COUNT; i++) {
      largest = Math.max(largest, Math.abs(keeps * will.get(i) - was.get(i)));
    }
    return largest;
  }
}
