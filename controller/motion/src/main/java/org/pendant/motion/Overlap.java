package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Overlap of two moves of any kind, of which the second begins before the first has come to rest:
 * how far each of them is away from the waypoint between them adds up, joint by joint. Both keep
 * their own laws of time, so this takes less time than a stop by as much as they share, whatever
 * their paths are.
 */
final class Overlap implements Motion {
  private static final int N = Joints.COUNT;

  /** Parts of the time that could be shared. */
  private static final int PARTS = 16;

  private final PathMotion first;
  private final PathMotion next;
  private final double sharedS;
  private final double durationS;
  private final double[] corner = new double[N];
  private final MotionSample added = new MotionSample();

  /**
   * The end of a move from where it may be taken over, and the start of the next.
   *
   * @param next from rest in the waypoint
   * @param sharedS how long before the end of the first one the next begins, s
   */
  Overlap(PathMotion first, PathMotion next, double sharedS) {
    this.first = first;
    this.next = next;
    this.sharedS = sharedS;
    durationS = first.restS();
    next.path().begin().copyTo(corner);
  }

  /**
   * The longest time that two moves may share.
   *
   * @param within how far on its path the next one may be in the end
   * @param factor by how much the strongest joint may be accelerated more than by either of both
   *     moves in the time that they could share
   */
  static double longestS(PathMotion first, PathMotion next, double within, double factor) {
    double mostS = Math.min(first.restS(), next.timeAt(within));
    double partS = mostS / PARTS;
    Needs slowing = new Needs();
    Needs starting = new Needs();
    if (!(mostS > 0)
        || !slowing.found(first, first.durationS() - mostS, partS)
        || !starting.found(next, 0, partS)) {
      return 0;
    }
    double allowed = factor * Math.max(slowing.largest(), starting.largest());
    int parts = PARTS;
    while (parts > 0 && slowing.largestWith(starting, parts) > allowed) {
      parts--;
    }
    return parts * partS;
  }

  /** What the joints need of a motion, part by part. */
  private static final class Needs {
    private final double[][] highest = new double[PARTS][N];
    private final double[][] lowest = new double[PARTS][N];

    boolean found(PathMotion motion, double fromS, double partS) {
      MotionSample point = new MotionSample();
      boolean found = true;
      for (int k = 0; found && k < PARTS; k++) {
        double beginS = fromS + k * partS;
        found = motion.accelerations(beginS, beginS + partS, point, highest[k], lowest[k]);
      }
      return found;
    }

    double largest() {
      double largest = 0;
      for (int k = 0; k < PARTS; k++) {
        for (int i = 0; i < N; i++) {
          largest = Math.max(largest, Math.max(highest[k][i], -lowest[k][i]));
        }
      }
      return largest;
    }

    /** The largest sum when the last parts of these fall together with the first of others. */
    double largestWith(Needs others, int parts) {
      double largest = 0;
      int ahead = PARTS - parts;
      for (int k = 0; k < parts; k++) {
        for (int i = 0; i < N; i++) {
          double most = highest[ahead + k][i] + others.highest[k][i];
          double least = lowest[ahead + k][i] + others.lowest[k][i];
          largest = Math.max(largest, Math.max(most, -least));
        }
      }
      return largest;
    }
  }

  /** Whether both moves together keep to the limits of what the payload does to the tool. */
  boolean keepsWrench(PathLimits pathLimits) {
    MotionSample point = new MotionSample();
    boolean keeps = true;
    double stepS = sharedS / (2 * PARTS);
    for (int k = 0; keeps && k <= 2 * PARTS; k++) {
      keeps =
          sample(durationS - sharedS + k * stepS, point).isEmpty()
              && pathLimits.wrenchShare(point) <= 1;
    }
    return keeps;
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    Optional<MotionFailure> failure = first.sample(first.handOverS() + timeS, sample);
    double nextS = timeS - (durationS - sharedS);
    if (failure.isPresent() || nextS <= 0) {
      return failure;
    }
    failure = next.sample(nextS, added);
    for (int i = 0; i < N; i++) {
      sample.position[i] += added.position[i] - corner[i];
      sample.speed[i] += added.speed[i];
      sample.acceleration[i] += added.acceleration[i];
    }
    return failure;
  }

  @Override
  public Optional<Pose> waypoint() {
    return next.waypoint();
  }
}
