package org.pendant.models.kinematics;

import java.util.List;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;

/** The ranges of the six joints, and the full turns they leave room for. */
final class JointRanges {
  /** A joint this much (rad) outside its range is moved to its end: rounding, not a violation. */
  private static final double LIMIT_ROUNDING = 1e-12;

  private static final double TURN = 2 * Math.PI;

  /** Less than half a turn, rad. */
  private static final double NO_TURN = 3;

  private final double[] min = new double[Joints.COUNT];
  private final double[] max = new double[Joints.COUNT];

  JointRanges(List<JointLimits> limits) {
    for (int i = 0; i < Joints.COUNT; i++) {
      min[i] = limits.get(i).lowestRad();
      max[i] = limits.get(i).highestRad();
    }
  }

  /**
   * Moves each joint by full turns, as near to {@code near} as its range permits; false if a range
   * has no place for its joint. Joints that are not numbers have none.
   */
  boolean turnNear(double[] q, double[] near) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double turned = q[i] - wholeTurns(q[i] - near[i]);
      if (turned > max[i] + LIMIT_ROUNDING) {
        turned -= TURN * Math.ceil((turned - max[i] - LIMIT_ROUNDING) / TURN);
      } else if (turned < min[i] - LIMIT_ROUNDING) {
        turned += TURN * Math.ceil((min[i] - LIMIT_ROUNDING - turned) / TURN);
      }
      if (!(turned >= min[i] - LIMIT_ROUNDING && turned <= max[i] + LIMIT_ROUNDING)) {
        return false;
      }
      q[i] = Math.max(min[i], Math.min(max[i], turned));
    }
    return true;
  }

  /** The position within the range of joint i that is nearest to one in rad, full turns aside. */
  double nearest(int i, double position) {
    if (position >= min[i] && position <= max[i]) {
      return position;
    }
    double below = offset(position, min[i]);
    double above = offset(position, max[i]);
    double turned = min[i] + TURN * fraction((position - min[i]) / TURN);
    return turned <= max[i] ? turned : below < above ? min[i] : max[i];
  }

  private static double fraction(double value) {
    return value - Math.floor(value);
  }

  /** Distance in rad of two angles, full turns aside. */
  static double offset(double a, double b) {
    return Math.abs(a - b - wholeTurns(a - b));
  }

  /** The full turns next to an angle; mostly none, and a division takes longer than to see that. */
  private static double wholeTurns(double angle) {
    return Math.abs(angle) < NO_TURN ? 0 : TURN * Math.rint(angle / TURN);
  }
}
