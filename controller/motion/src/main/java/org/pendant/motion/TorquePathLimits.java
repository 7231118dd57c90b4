package org.pendant.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/**
 * Path limits from the speeds and torques of the joints. At a few points q(s) of the path a rate v
 * and its derivative a take the torques
 *
 * <pre>  g(q) + (M q'' + c(q, q')) v² + M q' a, and friction that grows with v,</pre>
 *
 * which are known once the model has been asked three times: at rest, for a = 1 and for v = 1. (K.
 * Shin and N. McKay, "Minimum-time control of robotic manipulators with geometric path
 * constraints", IEEE Transactions on Automatic Control 30, 1985.) What {@link ToolWrenchLimit}
 * limits has the same form.
 *
 * <p>The two numbers hold for the whole path; they are not its time-optimal law. Only for the frame
 * loop that owns it.
 */
public final class TorquePathLimits {
  /** Points at which a path is looked at, its ends included. */
  static final int POINTS = 9;

  /** Parts between two of these points, at whose ends a path is checked against speed limits. */
  private static final int PARTS = 8;

  /** Share of a speed limit that is planned with: the path is not looked at everywhere. */
  private static final double LIMIT_SHARE = 0.99;

  /** Share of the torque limits that plans use: the rest is for servos that correct. */
  static final double TORQUE_SHARE = 0.9;

  /** Part of that which may go into keeping the speed, so that some is left to change it. */
  private static final double CRUISING_SHARE = 0.8;

  /** A joint that can hardly hold itself is still given this share of its torque to move. */
  private static final double MIN_SHARE = 0.05;

  /** Acceleration (rad/s² or m/s²) that needs no look at the joints: all arms can do that. */
  private static final double MODEST_PER_S2 = 3;

  /** Share of a wrench limit that is used: the path is not looked at everywhere. */
  private static final double WRENCH_SHARE = 0.95;

  /** Part of a wrench limit that may go into bends at even speed. */
  private static final double BENDING_SHARE = 0.5;

  private static final int HALVINGS = 30;
  private static final int RAMP_HALVINGS = 12;
  private static final int N = Joints.COUNT;
  private static final double[] REST = new double[N];

  private final ArmDynamics dynamics;
  private final double[] maxSpeed = new double[N];
  private final double[] torqueLimit = new double[N];
  private final double[] rotor = new double[N];
  private final List<Actuator> drives;

  private final MotionSample sample = new MotionSample();
  private final boolean[] known = new boolean[POINTS];
  private final double[][] holding = new double[POINTS][N];
  private final double[][] perRate = new double[POINTS][N];
  private final double[][] perSquare = new double[POINTS][N];
  private final double[][] perRate2 = new double[POINTS][N];
  private final double[][] wrenchPerSquare = new double[POINTS][Pose.SIZE];
  private final double[][] wrenchPerRate2 = new double[POINTS][Pose.SIZE];
  private final double[] still = new double[Pose.SIZE];
  private final double[] ofPath = new double[Pose.SIZE];
  private final double[] ofRamp = new double[Pose.SIZE];
  private final double[] ofLastPath = new double[Pose.SIZE];
  private final double[] ofLastRamp = new double[Pose.SIZE];
  private final double[] torque = new double[N];
  private final double[] limits = new double[Pose.SIZE];
  private double[] frame = new double[0];

  private PathLimiter speedLimits = PathLimiter.NONE;
  private double limitedRate;
  private Payload payload = Payload.NONE;
  private Optional<ToolWrenchLimit> wrenchLimit = Optional.empty();

  /** Headroom of an arm without payload. */
  public TorquePathLimits(ArmDescription arm) {
    dynamics = new ArmDynamics(arm);
    drives = arm.actuators();
    for (int i = 0; i < N; i++) {
      maxSpeed[i] = arm.joints().get(i).maxSpeedRadPerS();
      torqueLimit[i] = TORQUE_SHARE * arm.joints().get(i).maxTorqueNm();
      rotor[i] = arm.actuators().get(i).rotorInertiaKgM2();
    }
  }

  /**
   * Moves that share what the arm can do are planned within these limits from now on: what slows
   * them down on their way does so without limits on jerk.
   */
  public void limitSpeeds(PathLimiter limits) {
    speedLimits = limits;
  }

  /** What hangs on the flange. */
  public void setPayload(Payload now) {
    if (!now.equals(payload)) {
      payload = now;
      dynamics.setPayload(now);
    }
  }

  /** What the resting arm feels along the axes of the base, m/s². */
  public void setGravity(double x, double y, double z) {
    dynamics.setGravity(x, y, z);
  }

  /** Limits what the payload does to the tool from now on; empty for not any more. */
  public void setToolWrenchLimit(Optional<ToolWrenchLimit> limit) {
    wrenchLimit = limit;
    if (limit.isPresent()) {
      frame = limit.get().transform();
      for (int i = 0; i < Pose.SIZE; i++) {
        limits[i] = limit.get().limits().get(i);
      }
    }
  }

  /** The limit on what the payload does to the tool. */
  public Optional<ToolWrenchLimit> toolWrenchLimit() {
    return wrenchLimit;
  }

  /**
   * For a move that may use a share of what the joints can do.
   *
   * @param speedShare of the speed, above 0, at most 1
   * @param accelerationShare of the acceleration, above 0, at most 1
   * @param asked speed that the move asks for, per s; infinite if it asks for none
   */
  public PathLimits share(double speedShare, double accelerationShare, double asked) {
    return new OfArm() {
      @Override
      PathCaps found(double length) {
        double rate = fastest();
        double rate2 = accelerationShare * strongest(length, rate);
        double within = Math.min(speedShare * rate, LIMIT_SHARE * limitedRate);
        return wrenchKept(new PathCaps(within, rate2), asked);
      }

      @Override
      int parts() {
        return PARTS;
      }
    };
  }

  /**
   * For a move whose limits the program answers for: only its acceleration is kept within what the
   * joints can do, and the tool's wrench within its limits.
   *
   * @param limits that the move asks for
   */
  public PathLimits asAsked(MoveLimits limits) {
    boolean modest = !limits.timed() && limits.acceleration() <= MODEST_PER_S2;
    if (modest && wrenchLimit.isEmpty()) {
      return PathLimits.UNLIMITED;
    }
    double asked = limits.timed() ? Double.POSITIVE_INFINITY : limits.speed();
    return new OfArm() {
      @Override
      PathCaps found(double length) {
        double rate2 =
            modest ? Double.POSITIVE_INFINITY : strongest(length, Math.min(asked, fastest()));
        return wrenchKept(new PathCaps(Double.POSITIVE_INFINITY, rate2), asked);
      }
    };
  }

  /** Looks along a path with the model of this arm. */
  private abstract class OfArm implements PathLimits {
    /** What the points show that have been looked at. */
    abstract PathCaps found(double length);

    /** Into how many parts the path between two points is divided to look for speed limits. */
    int parts() {
      return 1;
    }

    @Override
    public PathCaps over(double length, Points points) {
      if (length == 0) {
        return PathCaps.NONE;
      }
      look(length, points, parts());
      return found(length);
    }

    @Override
    public boolean limitsWrench() {
      return wrenchLimit.isPresent();
    }

    @Override
    public double wrenchShare(MotionSample own) {
      double share = 0;
      if (wrenchLimit.isPresent()) {
        findWrenches(own);
        for (int i = 0; i < Pose.SIZE; i++) {
          share = Math.max(share, Math.abs(ofPath[i]) / (WRENCH_SHARE * limits[i]));
        }
      }
      return share;
    }
  }

  /** What the motion of a point does to the tool, and what a change of its speed adds. */
  private void findWrenches(MotionSample own) {
    dynamics.inverse(own.position, REST, REST, torque);
    wrench(still, REST);
    dynamics.inverse(own.position, REST, own.speed, torque);
    wrench(ofRamp, still);
    dynamics.inverse(own.position, own.speed, own.acceleration, torque);
    wrench(ofPath, still);
  }

  /**
   * The scaling of a motion's time that comes nearest to what is wanted within a frame and keeps
   * the tool's wrench within its limits: by a scaling s that changes by s' the joints accelerate by
   * {@code s² q'' + s' q'}, and the wrench is linear in that. Allocates nothing.
   *
   * @param last where the frame begins, in the motion's own time
   * @param own where it leads to
   * @param before the scaling of the frame before
   * @param wanted the scaling to come to
   */
  public double reachableScaling(
      MotionSample last, MotionSample own, double before, double wanted) {
    if (wrenchLimit.isEmpty() || before == wanted) {
      return wanted;
    }
    findWrenches(last);
    System.arraycopy(ofPath, 0, ofLastPath, 0, Pose.SIZE);
    System.arraycopy(ofRamp, 0, ofLastRamp, 0, Pose.SIZE);
    findWrenches(own);
    double reachable = before;
    double beyond = wanted;
    if (keepsWrench(before, wanted)) {
      return wanted;
    }
    for (int n = 0; n < RAMP_HALVINGS; n++) {
      double middle = 0.5 * (reachable + beyond);
      if (keepsWrench(before, middle)) {
        reachable = middle;
      } else {
        beyond = middle;
      }
    }
    return reachable;
  }

  /** Whether the scaling may change so within a frame, in which both points may mix. */
  private boolean keepsWrench(double before, double after) {
    double least = Math.min(before, after);
    double highest = Math.max(before, after);
    double perS = (after - before) / FrameTime.FRAME_S;
    boolean keeps = true;
    for (int i = 0; keeps && i < Pose.SIZE; i++) {
      double high = Math.max(ofPath[i], ofLastPath[i]);
      double low = Math.min(ofPath[i], ofLastPath[i]);
      high *= high > 0 ? highest * highest : least * least;
      low *= low < 0 ? highest * highest : least * least;
      high += Math.max(perS * ofRamp[i], perS * ofLastRamp[i]);
      low += Math.min(perS * ofRamp[i], perS * ofLastRamp[i]);
      keeps = Math.max(high, -low) <= WRENCH_SHARE * limits[i];
    }
    return keeps;
  }

  private void look(double length, PathLimits.Points points, int parts) {
    limitedRate = Double.POSITIVE_INFINITY;
    int last = (POINTS - 1) * parts;
    for (int n = 0; n <= last; n++) {
      sample.forgetFrames();
      boolean there = points.at(length * n / last, sample);
      if (there && parts > 1) {
        // for a rate of 1: every one of these limits is on something that grows with the rate
        limitedRate = Math.min(limitedRate, sample.largestScaling(speedLimits));
      }
      int k = n / parts;
      if (n % parts == 0) {
        known[k] = there;
      }
      if (n % parts == 0 && there) {
        double[] d = sample.speed;
        dynamics.inverse(sample.position, REST, REST, holding[k]);
        wrench(still, REST);
        dynamics.inverse(sample.position, REST, d, perRate2[k]);
        wrench(wrenchPerRate2[k], still);
        dynamics.inverse(sample.position, d, sample.acceleration, perSquare[k]);
        wrench(wrenchPerSquare[k], still);
        for (int i = 0; i < N; i++) {
          perRate[k][i] = Math.abs(d[i]);
          perRate2[k][i] += rotor[i] * d[i] - holding[k][i];
          perSquare[k][i] += rotor[i] * sample.acceleration[i] - holding[k][i];
        }
      }
    }
  }

  /** What the latest motion of the model does to the tool, less what is not of the motion. */
  private void wrench(double[] wrench, double[] less) {
    if (wrenchLimit.isPresent()) {
      dynamics.flangeMotion().loadOf(payload, wrench);
      ToolWrenchLimit.carry(wrench, frame);
      for (int i = 0; i < Pose.SIZE; i++) {
        wrench[i] -= less[i];
      }
    }
  }

  /** The highest rate that every joint can follow and hold. */
  private double fastest() {
    double rate = Double.MAX_VALUE;
    for (int k = 0; k < POINTS; k++) {
      for (int i = 0; known[k] && i < N; i++) {
        rate = Math.min(rate, maxSpeed[i] / perRate[k][i]);
      }
    }
    for (int k = 0; k < POINTS; k++) {
      for (int i = 0; known[k] && i < N; i++) {
        if (torqueAt(k, i, rate) > cruisingLimit(k, i)) {
          rate = slower(k, i, rate);
        }
      }
    }
    return rate;
  }

  private double cruisingLimit(int k, int i) {
    double resting = torqueAt(k, i, 0);
    return Math.max(CRUISING_SHARE * torqueLimit[i], resting + MIN_SHARE * torqueLimit[i]);
  }

  private double slower(int k, int i, double rate) {
    double low = 0;
    double high = rate;
    for (int n = 0; n < HALVINGS; n++) {
      double middle = 0.5 * (low + high);
      if (torqueAt(k, i, middle) > cruisingLimit(k, i)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return high;
  }

  /** The torque of joint i at point k for an even rate, whichever way it turns, Nm. */
  private double torqueAt(int k, int i, double rate) {
    double load = Math.abs(holding[k][i] + perSquare[k][i] * rate * rate);
    return load + drives.get(i).slidingNm(perRate[k][i] * rate, load);
  }

  /**
   * The strongest change of the rate: at the ends of the path from rest, and in between at the rate
   * that has come up by then.
   */
  private double strongest(double length, double rate) {
    double rate2 = Double.MAX_VALUE;
    for (int k = 0; k < POINTS; k++) {
      rate2 = Math.min(rate2, strongestAt(k, 0));
    }
    double fromRest = rate2;
    for (int k = 1; k < POINTS - 1; k++) {
      double way = length * Math.min(k, POINTS - 1 - k) / (POINTS - 1);
      double reached = Math.sqrt(2 * fromRest * way);
      // where the path is travelled evenly nothing is left to change
      if (reached < 2 * rate) {
        rate2 = Math.min(rate2, strongestAt(k, Math.min(rate, reached)));
      }
    }
    return rate2;
  }

  private double strongestAt(int k, double rate) {
    double rate2 = Double.MAX_VALUE;
    for (int i = 0; known[k] && i < N; i++) {
      double left = Math.max(torqueLimit[i] - torqueAt(k, i, rate), MIN_SHARE * torqueLimit[i]);
      rate2 = Math.min(rate2, left / Math.abs(perRate2[k][i]));
    }
    return rate2;
  }

  private PathCaps wrenchKept(PathCaps caps, double asked) {
    if (wrenchLimit.isEmpty()) {
      return caps;
    }
    double rate = Math.min(caps.rate(), asked);
    double bent = caps.rate();
    for (int k = 0; k < POINTS; k++) {
      for (int i = 0; known[k] && i < Pose.SIZE; i++) {
        double room = BENDING_SHARE * WRENCH_SHARE * wrenchLimit.get().limits().get(i);
        double most = Math.sqrt(room / Math.abs(wrenchPerSquare[k][i]));
        bent = Double.isNaN(most) ? bent : Math.min(bent, most);
      }
    }
    rate = Math.min(rate, bent);
    double rate2 = caps.rate2();
    for (int k = 0; k < POINTS; k++) {
      for (int i = 0; known[k] && i < Pose.SIZE; i++) {
        double square = Math.abs(wrenchPerSquare[k][i]);
        double used = square == 0 ? 0 : square * rate * rate;
        double room = WRENCH_SHARE * wrenchLimit.get().limits().get(i) - used;
        double most = room / Math.abs(wrenchPerRate2[k][i]);
        rate2 = Double.isNaN(most) ? rate2 : Math.min(rate2, most);
      }
    }
    return new PathCaps(bent, rate2);
  }
}
