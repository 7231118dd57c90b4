package org.pendant.motion;

import java.util.SplittableRandom;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * A move with a blend radius and the same one without, and where both lead.
 *
 * @param ofTool whether the tool's path is the one asked for
 */
record RandomLeg(Move blended, Move stopping, Joints goal, boolean ofTool) {
  /** Every kind of move. */
  static final int[] KINDS = {0, 1, 2, 3, 4, 5};

  /**
   * A leg of random shape.
   *
   * @param kinds to choose from: 0 movej, 1 movel, 2 movep, 3 movec, 4 optimovej, 5 optimovel
   * @param r blend radius, m
   * @param ramp how long the acceleration takes to grow, s
   */
  static RandomLeg of(
      MoveChain chain,
      InverseKinematics inverse,
      SplittableRandom random,
      int[] kinds,
      Joints from,
      double r,
      double ramp) {
    Pose goal =
        chain.shifted(
            random.nextDouble(-0.12, 0.12),
            random.nextDouble(-0.12, 0.12),
            random.nextDouble(-0.12, 0.12));
    Pose turned =
        Poses.trans(
            goal, new Pose(0, 0, 0, random.nextDouble(-0.3, 0.3), random.nextDouble(-0.3, 0.3), 0));
    Joints q =
        inverse.closest(InverseKinematics.flangeOf(turned, MoveChain.TCP), from).orElseThrow();
    double a = random.nextDouble(0.3, 3);
    double v = random.nextDouble(0.05, 0.5);
    double share = random.nextDouble(0.05, 0.6);
    Pose via = between(chain.tcp(from), goal, random);
    int kind = kinds[random.nextInt(kinds.length)];
    return new RandomLeg(
        move(chain, kind, q, turned, via, a, v, share, r, ramp),
        move(chain, kind, q, turned, via, a, v, share, 0, ramp),
        q,
        kind != 0 && kind != 4);
  }

  private static Pose between(Pose from, Pose to, SplittableRandom random) {
    Pose middle = Poses.interpolate(from, to, 0.5);
    double aside = random.nextDouble(0.05, 0.2) * Poses.pointDistance(from, to);
    return new Pose(middle.x() + aside, middle.y() - aside, middle.z() + aside, 0, 0, 0);
  }

  private static Move move(
      MoveChain chain,
      int kind,
      Joints q,
      Pose goal,
      Pose via,
      double a,
      double v,
      double share,
      double r,
      double ramp) {
    return switch (kind) {
      case 0 -> chain.movej(q, 2 * a, 3 * v, r, ramp);
      case 1 -> chain.movel(goal, a, v, r, ramp);
      case 2 -> chain.movep(goal, a, v, r);
      case 3 -> chain.movec(via, goal, a, v, r, false);
      case 4 -> chain.optimovej(q, share, share, r);
      case 5 -> chain.optimovel(goal, share, share, r);
      default -> throw new IllegalArgumentException("kind is " + kind);
    };
  }
}
