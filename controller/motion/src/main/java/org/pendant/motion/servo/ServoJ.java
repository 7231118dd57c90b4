package org.pendant.motion.servo;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionSample;
import org.pendant.motion.StopJ;

/**
 * Joint servo motion: each joint is drawn to its goal (manual 15.44): {@code qdd = gain (goal - (q
 * + lookahead qd))}, within what the arm can do. A joint that runs after a goal of constant speed
 * is behind it by the lookahead time.
 *
 * <p>The acceleration is even within each frame of the motion's own time.
 */
final class ServoJ implements Motion {
  /** No joint is asked to speed up or slow down faster, rad/s²; our choice. */
  static final double MAX_RAD_PER_S2 = 40;

  private static final int N = Joints.COUNT;

  private static final Optional<MotionPlan> ENDING =
      Optional.of((q, qd) -> new StopJ(q, qd, MotionControl.SCALING_ACCELERATION_RAD_PER_S2));

  private final List<JointLimits> limits;
  private final Joints goal;
  private final double timeS;
  private final double lookaheadS;
  private final double gain;

  /** Where the frame begins that is being sampled, how fast, and its acceleration. */
  private final double[] q = new double[N];

  private final double[] qd = new double[N];
  private final double[] qdd = new double[N];

  /** The number of that frame. */
  private int frame;

  /** The accelerations of the frame before it: a sample may go back by less than a frame. */
  private final double[] qddBefore = new double[N];

  ServoJ(
      List<JointLimits> limits,
      Joints from,
      Joints speed,
      Joints goal,
      double timeS,
      double lookaheadS,
      double gain) {
    this.limits = limits;
    this.goal = goal;
    this.timeS = timeS;
    this.lookaheadS = lookaheadS;
    this.gain = gain;
    from.copyTo(q);
    speed.copyTo(qd);
    accelerate();
  }

  /** Finds the accelerations of the frame that begins. */
  private void accelerate() {
    for (int i = 0; i < N; i++) {
      double wanted = gain * (goal.get(i) - (q[i] + lookaheadS * qd[i]));
      double possible = Math.max(-MAX_RAD_PER_S2, Math.min(MAX_RAD_PER_S2, wanted));
      double slowed = Math.abs(qd[i]) - MAX_RAD_PER_S2 * FrameTime.FRAME_S;
      double most = Math.max(limits.get(i).maxSpeedRadPerS(), slowed);
      double speed = Math.max(-most, Math.min(most, qd[i] + possible * FrameTime.FRAME_S));
      qdd[i] = (speed - qd[i]) / FrameTime.FRAME_S;
    }
  }

  @Override
  public double durationS() {
    return Servoing.ENDLESS_S;
  }

  @Override
  public double handOverS() {
    return timeS;
  }

  @Override
  public boolean timed() {
    return true;
  }

  @Override
  public Optional<MotionPlan> ending() {
    return ENDING;
  }

  @Override
  public String driver() {
    return "servoj";
  }

  @Override
  public Optional<MotionFailure> sample(double atS, MotionSample sample) {
    while ((frame + 1) * FrameTime.FRAME_S < atS) {
      nextFrame();
    }
    double t = atS - frame * FrameTime.FRAME_S;
    for (int i = 0; i < N; i++) {
      double a = t < 0 ? qddBefore[i] : qdd[i];
      sample.set(i, q[i] + t * (qd[i] + t * 0.5 * a), qd[i] + t * a, a);
    }
    return Optional.empty();
  }

  private void nextFrame() {
    double t = FrameTime.FRAME_S;
    for (int i = 0; i < N; i++) {
      q[i] += t * (qd[i] + t * 0.5 * qdd[i]);
      qd[i] += t * qdd[i];
      qddBefore[i] = qdd[i];
    }
    frame++;
    accelerate();
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
