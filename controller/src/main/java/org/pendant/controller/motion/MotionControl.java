package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Owns the motion that is under way and the target it yields, one a frame.
 *
 * <p>The motion's own time advances by the speed scaling times the frame. Pausing, stopping and the
 * speed slider change only that scaling, in ramps, so the path is the same whatever happens on the
 * way. Motion time is counted in frames, and a motion at full speed is evaluated at whole ones: it
 * is never integrated.
 */
public final class MotionControl {
  /** How fast a change of the scaling may change the speed of the fastest joint, rad/s². */
  public static final double SCALING_ACCELERATION_RAD_PER_S2 = 8;

  /** How fast the arm stops when its path cannot be followed any further, rad/s². */
  public static final double FAULT_DECELERATION_RAD_PER_S2 = 15;

  /** The slowest that time on a path may run; a path that needs it slower cannot be followed. */
  private static final double SLOWEST_SCALING = 0.02;

  /** Frames at rest after which the arm counts as steady: 500 ms (manual 16.39). */
  private static final int STEADY_FRAMES = 250;

  /** Room for the mean speed of a frame, which may exceed the speeds at both of its ends. */
  private static final double MEAN_SPEED_TOLERANCE = 1.01;

  private static final MotionFailure POWER_LOST =
      new MotionFailure("power-off", "the arm has no power");

  private final PathLimiter limiter;
  private final double[] maxSpeed = new double[Joints.COUNT];
  private final MotionSample sample = new MotionSample();
  private final double[] previous = new double[Joints.COUNT];

  private Joints position;
  private Joints speed = Joints.ZERO;
  private Joints acceleration = Joints.ZERO;

  private Optional<Motion> active = Optional.empty();
  private Optional<MotionTicket> owner = Optional.empty();
  private Optional<Pending> pending = Optional.empty();
  private Optional<MotionFailure> fault = Optional.empty();
  private double motionFrames;

  private double speedFraction = 1;
  private double scaling = 1;
  private double scalingRampRadPerS2 = SCALING_ACCELERATION_RAD_PER_S2;
  private boolean paused;

  /** The motion is a stop: neither slider nor pause makes it longer. */
  private boolean stopping;

  /** Nobody wants the motion any more: it ends where the scaling reaches 0. */
  private boolean releasing;

  private int framesAtRest = STEADY_FRAMES;

  private record Pending(MotionPlan plan, MotionTicket ticket) {}

  /** At rest at {@code positionRad}, limited by nothing but the arm's own joint speeds. */
  public MotionControl(ArmDescription arm, Joints positionRad) {
    this(arm, positionRad, PathLimiter.NONE);
  }

  /**
   * At rest at {@code positionRad}.
   *
   * @param limiter slows motions down where they would exceed what it knows
   */
  public MotionControl(ArmDescription arm, Joints positionRad, PathLimiter limiter) {
    this.limiter = limiter;
    for (int i = 0; i < Joints.COUNT; i++) {
      maxSpeed[i] = arm.joints().get(i).maxSpeedRadPerS();
    }
    position = positionRad;
  }

  /**
   * Starts a motion that begins at rest. If the arm still comes to rest from one that nobody waits
   * for, it starts right after that.
   *
   * @throws ScriptError when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket start(MotionPlan plan) throws ScriptError {
    refuseSecondOwner();
    MotionTicket ticket = new MotionTicket(this);
    if (active.isPresent()) {
      pending = Optional.of(new Pending(plan, ticket));
    } else {
      begin(plan.from(position, Joints.ZERO), Optional.of(ticket), false);
    }
    return ticket;
  }

  /**
   * Starts a motion that goes on from the present speed; for stops.
   *
   * @throws ScriptError when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket takeOver(MotionPlan plan) throws ScriptError {
    refuseSecondOwner();
    MotionTicket ticket = new MotionTicket(this);
    begin(plan.from(position, speed), Optional.of(ticket), true);
    return ticket;
  }

  private void refuseSecondOwner() throws ScriptError {
    if (owner.isPresent() || pending.isPresent()) {
      throw new ScriptError(
          "robot-in-use", "another thread controls the robot, only one can at a time");
    }
  }

  private void begin(Motion motion, Optional<MotionTicket> ticket, boolean stop) {
    active = Optional.of(motion);
    owner = ticket;
    stopping = stop;
    motionFrames = 0;
    releasing = false;
    scaling = scalingGoal();
  }

  /** Gives the next target; step 3 of a frame. */
  public void step() {
    if (active.isEmpty() && pending.isPresent()) {
      beginPending(pending.get());
    }
    if (active.isPresent()) {
      follow(active.get());
    } else {
      speed = Joints.ZERO;
      acceleration = Joints.ZERO;
    }
    framesAtRest = speed.equals(Joints.ZERO) ? Math.min(framesAtRest + 1, STEADY_FRAMES) : 0;
  }

  private void beginPending(Pending next) {
    pending = Optional.empty();
    try {
      begin(next.plan.from(position, Joints.ZERO), Optional.of(next.ticket), false);
    } catch (ScriptError e) {
      next.ticket.fail(new MotionFailure(e.code(), e.getMessage()));
    }
  }

  private void follow(Motion motion) {
    double before = scaling;
    double framesBefore = motionFrames;
    scaling = nextScaling();
    position.copyTo(previous);
    Optional<MotionFailure> failure = sampleAfter(motion, framesBefore, before);
    if (failure.isEmpty() && !stopping && scaling > 0) {
      double largest = limiter.largestScaling(sample.position, sample.speed);
      if (!(largest >= SLOWEST_SCALING)) {
        failure = Optional.of(tooSlow());
      } else if (largest < scaling) {
        scaling = largest;
        failure = sampleAfter(motion, framesBefore, before);
      }
    }
    if (failure.isEmpty()) {
      failure = tooFast();
    }
    if (failure.isPresent()) {
      stopBeside(failure.get());
      return;
    }
    publish((scaling - before) / FrameTime.FRAME_S);
    if (atEnd(motion) || (scaling == 0 && releasing)) {
      owner.ifPresent(MotionTicket::finish);
      forget();
    }
  }

  /** Samples the motion a frame further, its time running evenly from one scaling to the next. */
  private Optional<MotionFailure> sampleAfter(Motion motion, double framesBefore, double before) {
    motionFrames = framesBefore + 0.5 * (before + scaling);
    double timeS = atEnd(motion) ? motion.durationS() : motionFrames * FrameTime.FRAME_S;
    return motion.sample(timeS, sample);
  }

  private boolean atEnd(Motion motion) {
    return motionFrames >= motion.durationS() / FrameTime.FRAME_S - FrameTime.ROUNDING;
  }

  private double scalingGoal() {
    if (stopping) {
      return 1;
    }
    return paused || releasing ? 0 : speedFraction;
  }

  /** The scaling of the next frame: towards its goal as fast as the joints may change speed. */
  private double nextScaling() {
    double goal = scalingGoal();
    if (goal == scaling) {
      return scaling;
    }
    double fastest = 0;
    for (double each : sample.speed) {
      fastest = Math.max(fastest, Math.abs(each));
    }
    double step = scalingRampRadPerS2 * FrameTime.FRAME_S / fastest;
    return goal < scaling ? Math.max(goal, scaling - step) : Math.min(goal, scaling + step);
  }

  private Optional<MotionFailure> tooFast() {
    for (int i = 0; i < Joints.COUNT; i++) {
      double moved = Math.abs(sample.position[i] - previous[i]) / FrameTime.FRAME_S;
      double needed = Math.max(moved, Math.abs(sample.speed[i]) * scaling);
      if (!(needed <= maxSpeed[i] * MEAN_SPEED_TOLERANCE)) {
        return Optional.of(
            new MotionFailure(
                "joint-speed",
                "joint "
                    + i
                    + " would turn at "
                    + Value.of(needed).text()
                    + " rad/s, must be at most "
                    + Value.of(maxSpeed[i]).text()
                    + " rad/s; the path is too fast or passes close to a singularity"));
      }
    }
    return Optional.empty();
  }

  private MotionFailure tooSlow() {
    int fastest = 0;
    for (int i = 1; i < Joints.COUNT; i++) {
      if (Math.abs(sample.speed[i]) > Math.abs(sample.speed[fastest])) {
        fastest = i;
      }
    }
    return new MotionFailure(
        "singularity",
        "the path passes too close to a singularity: joint "
            + fastest
            + " would turn at "
            + Value.of(Math.abs(sample.speed[fastest])).text()
            + " rad/s; a joint move can pass it");
  }

  private void publish(double scalingPerS) {
    position = Joints.of(sample.position);
    double squared = scaling * scaling;
    double[] v = sample.speed;
    double[] a = sample.acceleration;
    speed = scaled(scaling, v, 0, v);
    acceleration = scaled(squared, a, scalingPerS, v);
  }

  private static Joints scaled(double f, double[] x, double g, double[] y) {
    Joints sum =
        new Joints(
            f * x[0] + g * y[0],
            f * x[1] + g * y[1],
            f * x[2] + g * y[2],
            f * x[3] + g * y[3],
            f * x[4] + g * y[4],
            f * x[5] + g * y[5]);
    return isZero(sum) ? Joints.ZERO : sum;
  }

  private static boolean isZero(Joints q) {
    return q.q0() == 0 && q.q1() == 0 && q.q2() == 0 && q.q3() == 0 && q.q4() == 0 && q.q5() == 0;
  }

  private void forget() {
    active = Optional.empty();
    owner = Optional.empty();
    releasing = false;
    stopping = false;
    sample.rest();
    scaling = scalingGoal();
  }

  /** The path cannot be followed: all joints stop from what they do now. */
  private void stopBeside(MotionFailure failure) {
    fault = Optional.of(failure);
    owner.ifPresent(ticket -> ticket.fail(failure));
    pending.ifPresent(next -> next.ticket.fail(failure));
    pending = Optional.empty();
    forget();
    if (speed.equals(Joints.ZERO)) {
      acceleration = Joints.ZERO;
      return;
    }
    begin(new StopJ(position, speed, FAULT_DECELERATION_RAD_PER_S2), Optional.empty(), true);
  }

  /** Lets the arm come to rest on its path and forgets the motion. */
  public void abort() {
    owner = Optional.empty();
    pending = Optional.empty();
    releasing = active.isPresent();
  }

  void endEarly(MotionTicket ticket) {
    if (owner.isPresent() && owner.get() == ticket) {
      releasing = true;
    } else if (pending.isPresent() && pending.get().ticket == ticket) {
      pending = Optional.empty();
      ticket.finish();
    }
  }

  void release(MotionTicket ticket) {
    if (pending.isPresent() && pending.get().ticket == ticket) {
      pending = Optional.empty();
    }
    if (owner.isPresent() && owner.get() == ticket) {
      owner = Optional.empty();
      releasing = true;
    }
  }

  /** Comes to rest on the path and keeps the motion for {@link #resume}. */
  public void pause() {
    halt(SCALING_ACCELERATION_RAD_PER_S2);
  }

  /**
   * As {@link #pause}, for stops that must be shorter.
   *
   * @param decelerationRadPerS2 of the fastest joint, above 0
   */
  public void halt(double decelerationRadPerS2) {
    paused = true;
    scalingRampRadPerS2 = decelerationRadPerS2;
  }

  /** Goes on after {@link #pause} or {@link #halt}. */
  public void resume() {
    paused = false;
    scalingRampRadPerS2 = SCALING_ACCELERATION_RAD_PER_S2;
  }

  /** Gives up every motion: the arm has been stopped by its brakes and rests elsewhere. */
  public void adopt(Joints positionRad) {
    owner.ifPresent(ticket -> ticket.fail(POWER_LOST));
    pending.ifPresent(next -> next.ticket.fail(POWER_LOST));
    pending = Optional.empty();
    forget();
    position = positionRad;
    speed = Joints.ZERO;
    acceleration = Joints.ZERO;
  }

  /**
   * Sets the speed slider.
   *
   * @param fraction 0 to 1
   * @throws IllegalArgumentException outside of that
   */
  public void setSpeedFraction(double fraction) {
    if (!(fraction >= 0 && fraction <= 1)) {
      throw new IllegalArgumentException("speed fraction is " + fraction + ", must be 0 to 1");
    }
    speedFraction = fraction;
  }

  /**
   * Puts the target elsewhere, at rest.
   *
   * @throws ScriptError while a motion is under way
   */
  public void jumpTo(Joints positionRad) throws ScriptError {
    if (moving()) {
      throw new ScriptError("robot-in-use", "the arm is moving, must be at rest");
    }
    position = positionRad;
  }

  /** A new program starts: what stopped the last one is over. */
  public void clearFault() {
    fault = Optional.empty();
  }

  /** What made the arm leave its path and stop. */
  public Optional<MotionFailure> fault() {
    return fault;
  }

  /** Whether a motion is under way, a paused one included. */
  public boolean moving() {
    return active.isPresent() || pending.isPresent();
  }

  /** Whether the target has rested for 500 ms. */
  public boolean steady() {
    return framesAtRest >= STEADY_FRAMES;
  }

  /** Where the active move takes the TCP, in the base frame. */
  public Optional<Pose> waypoint() {
    return active.flatMap(Motion::waypoint);
  }

  /** The speed slider, 0 to 1. */
  public double speedFraction() {
    return speedFraction;
  }

  /** How fast motion time runs against the clock, 0 to 1. */
  public double scaling() {
    return scaling;
  }

  /** Target positions, rad. */
  public Joints positionRad() {
    return position;
  }

  /** Target speeds, rad/s. */
  public Joints speedRadPerS() {
    return speed;
  }

  /** Target accelerations, rad/s². */
  public Joints accelerationRadPerS2() {
    return acceleration;
  }
}
