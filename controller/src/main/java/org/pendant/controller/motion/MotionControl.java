package org.pendant.controller.motion;

import java.util.List;
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

  private static final MotionFailure PATH_ENDED =
      new MotionFailure("path-ended", "another motion has taken the arm over");

  private static final MotionFailure POWER_LOST =
      new MotionFailure("power-off", "the arm has no power");

  private final PathLimiter limiter;
  private final JointSpeedCheck jointSpeeds;
  private final MotionSample sample = new MotionSample();
  private final double[] previous = new double[Joints.COUNT];

  private final OffsetTarget offsets;

  /** Where the path is; the target too unless {@link #offsets} are engaged. */
  private Joints position;

  private Joints speed = Joints.ZERO;
  private Joints acceleration = Joints.ZERO;

  private Optional<Motion> active = Optional.empty();
  private Optional<MotionTicket> owner = Optional.empty();
  private Optional<Pending> pending = Optional.empty();
  private Optional<MotionFailure> fault = Optional.empty();
  private double motionFrames;

  private final PathTime time = new PathTime();

  /** Whoever asked for the motion goes on now, and may blend into another. */
  private boolean handedOver;

  /** The arm is guided by hand, and the target follows it. */
  private boolean guided;

  private int framesAtRest = STEADY_FRAMES;

  /** Plans a move that has not begun to move, as often as more becomes known of what follows it. */
  private interface Planning {
    Optional<Motion> knowing(List<Move> outlook) throws ScriptError;
  }

  /** The plan of a move that has just begun, and that would gain from an outlook. */
  private Optional<Planning> unforeseen = Optional.empty();

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
    offsets = new OffsetTarget(arm);
    jointSpeeds = new JointSpeedCheck(arm);
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
   * Starts a move; from rest, or blending with the move before it where that one allows it and has
   * just been handed over.
   *
   * @return empty if the move is left out because its blend overlaps with the one before (manual
   *     15.29)
   * @throws ScriptError when it cannot be planned, or another thread's motion is under way
   */
  public Optional<MotionTicket> start(Move move) throws ScriptError {
    refuseSecondOwner();
    if (handedOver && active.orElseThrow().leaving().isEmpty()) {
      return startFromRest(move);
    }
    MotionTicket ticket = new MotionTicket(this);
    if (active.isPresent() && !handedOver) {
      MotionPlan plan = (from, atSpeed) -> MovePlanner.fromRest(move, from, List.of());
      pending = Optional.of(new Pending(plan, ticket));
      return Optional.of(ticket);
    }
    Planning planning = handedOver ? joining(move) : fromRest(move);
    Optional<Motion> motion = planning.knowing(List.of());
    if (motion.isEmpty()) {
      return Optional.empty();
    }
    boolean moves = handedOver;
    begin(motion.get(), Optional.of(ticket));
    if (moves) {
      time.goOn();
    } else {
      time.begin(false);
    }
    unforeseen = move.blendRadiusM() > 0 ? Optional.of(planning) : Optional.empty();
    return Optional.of(ticket);
  }

  /** After a motion without an end, such as speedj; that one cannot be blended with. */
  private Optional<MotionTicket> startFromRest(Move move) throws ScriptError {
    if (!speed.equals(Joints.ZERO)) {
      throw new ScriptError(
          "moving",
          "the arm is moving at "
              + Value.of(speed.maxAbsDifference(Joints.ZERO)).text()
              + " rad/s, must be at rest before a move; stopj or stopl brings it to rest");
    }
    forget();
    return start(move);
  }

  private Planning fromRest(Move move) {
    Joints from = position;
    return outlook -> Optional.of(MovePlanner.fromRest(move, from, outlook));
  }

  private Planning joining(Move move) {
    Motion present = active.orElseThrow();
    PathMotion leaving = present.leaving().orElseThrow();
    double leavingS =
        leaving.handOverS() - (present.handOverS() - motionFrames * FrameTime.FRAME_S);
    return outlook -> MovePlanner.blended(leaving, leavingS, move, outlook);
  }

  boolean wantsOutlook(MotionTicket ticket) {
    return unforeseen.isPresent() && owner.isPresent() && owner.get() == ticket;
  }

  void outlook(MotionTicket ticket, List<Move> next) {
    if (wantsOutlook(ticket) && !next.isEmpty()) {
      try {
        active = unforeseen.get().knowing(next);
      } catch (ScriptError e) {
        // the next move cannot be made; it will say so itself when its turn comes
      }
    }
    unforeseen = Optional.empty();
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
    refuseGuided();
    if (owner.isPresent() || pending.isPresent()) {
      throw new ScriptError(
          "robot-in-use", "another thread controls the robot, only one can at a time");
    }
  }

  private void refuseGuided() throws ScriptError {
    if (guided) {
      throw new ScriptError("freedrive", "the arm is in freedrive, which must be ended first");
    }
  }

  private void begin(Motion motion, Optional<MotionTicket> ticket, boolean stop) {
    begin(motion, ticket);
    time.begin(stop);
  }

  private void begin(Motion motion, Optional<MotionTicket> ticket) {
    active = Optional.of(motion);
    owner = ticket;
    handedOver = false;
    unforeseen = Optional.empty();
    motionFrames = 0;
  }

  /**
   * From now on the arm is guided by hand: a motion that nobody waits for is dropped, and so are
   * offsets; none can start, and {@link #guide} says where the target is.
   *
   * @throws ScriptError when a thread's motion is under way
   */
  public void startGuidance() throws ScriptError {
    if (!guided) {
      refuseSecondOwner();
      takeTargetForPath();
      offsets.end();
      guided = true;
    }
  }

  /** The target is where the guided arm is. */
  public void guide(Joints positionRad, Joints speedRadPerS) {
    position = positionRad;
    speed = speedRadPerS;
    acceleration = Joints.ZERO;
  }

  /** The arm is no longer guided: the target comes to rest from where the arm is. */
  public void endGuidance() {
    if (guided) {
      guided = false;
      if (!speed.equals(Joints.ZERO)) {
        begin(new StopJ(position, speed, SCALING_ACCELERATION_RAD_PER_S2), Optional.empty(), true);
      }
    }
  }

  /** Whether the arm is guided by hand. */
  public boolean guided() {
    return guided;
  }

  /** Gives the next target; step 3 of a frame. */
  public void step() {
    if (guided) {
      framesAtRest = 0;
      return;
    }
    if (handedOver) {
      handedOver = false;
      endUncontinued();
    }
    unforeseen = Optional.empty();
    if (active.isEmpty() && pending.isPresent()) {
      beginPending(pending.get());
    }
    if (active.isPresent()) {
      follow(active.get());
    } else {
      speed = Joints.ZERO;
      acceleration = Joints.ZERO;
    }
    carryAside();
    framesAtRest =
        speedRadPerS().equals(Joints.ZERO) ? Math.min(framesAtRest + 1, STEADY_FRAMES) : 0;
  }

  /** Nobody has taken the motion over: it ends as it says itself. */
  private void endUncontinued() {
    Optional<MotionPlan> ending = active.flatMap(Motion::ending);
    if (ending.isPresent()) {
      try {
        begin(ending.get().from(position, speed), Optional.empty(), true);
      } catch (ScriptError e) {
        stopBeside(new MotionFailure(e.code(), e.getMessage()));
      }
    }
  }

  private void carryAside() {
    Optional<MotionFailure> failure = offsets.step(position, speed);
    if (failure.isEmpty() && offsets.engaged()) {
      failure = jointSpeeds.carried(offsets.speed());
    }
    if (failure.isPresent()) {
      takeTargetForPath();
      offsets.end();
      stopBeside(failure.get());
    }
  }

  /** Offsets carry the TCP aside, each after those added before. */
  public void addOffset(PathOffset offset) {
    offsets.add(offset);
  }

  /** The TCP that offsets carry, in the flange frame. */
  public void setTool(Pose inFlange) {
    offsets.setTool(inFlange);
  }

  /**
   * From now on the path is where the target is, so that an offset can end without a jump. A motion
   * under way is given up; whoever ends an offset stops the arm with {@link #takeOver}.
   */
  public void takeTargetForPath() {
    Joints target = positionRad();
    Joints targetSpeed = speedRadPerS();
    Joints targetAcceleration = accelerationRadPerS2();
    owner.ifPresent(ticket -> ticket.fail(PATH_ENDED));
    forget();
    position = target;
    speed = targetSpeed;
    acceleration = targetAcceleration;
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
    double before = time.scaling();
    double framesBefore = motionFrames;
    time.step(sample.fastestRadPerS());
    position.copyTo(previous);
    Optional<MotionFailure> failure = sampleAfter(motion, framesBefore, before);
    if (failure.isEmpty() && !time.stopping() && time.scaling() > 0) {
      double largest = limiter.largestScaling(sample.position, sample.speed);
      if (!(largest >= SLOWEST_SCALING)) {
        failure = Optional.of(JointSpeedCheck.singular(sample));
      } else if (largest < time.scaling()) {
        time.lowerTo(largest);
        failure = sampleAfter(motion, framesBefore, before);
      }
    }
    if (failure.isEmpty()) {
      failure = jointSpeeds.onPath(previous, sample, time.scaling());
    }
    if (failure.isPresent()) {
      stopBeside(failure.get());
      return;
    }
    publish((time.scaling() - before) / FrameTime.FRAME_S);
    if (atEnd(motion) || (time.scaling() == 0 && time.releasing())) {
      owner.ifPresent(MotionTicket::finish);
      forget();
    } else if (owner.isPresent() && motion.handOverS() < motion.durationS() && !time.releasing()) {
      handOver(motion);
    }
  }

  /**
   * Whoever waits for the motion goes on, to say what comes next: a frame before a move may be left
   * for another, or when a motion without an end has lasted as long as it was asked to.
   */
  private void handOver(Motion motion) {
    double atFrame = motion.handOverS() / FrameTime.FRAME_S - FrameTime.ROUNDING;
    boolean due =
        motion.leaving().isPresent() ? motionFrames + 1 > atFrame : motionFrames >= atFrame;
    if (due) {
      owner.orElseThrow().finish();
      owner = Optional.empty();
      handedOver = true;
    }
  }

  /**
   * Whether an arm that slows down from now on comes to rest behind the point where its move is
   * handed over, so that whoever asked for it has to say before where it leads on.
   */
  public boolean handsOverBeforeRest() {
    if (handedOver || owner.isEmpty() || active.isEmpty() || active.get().leaving().isEmpty()) {
      return handedOver;
    }
    double rampS = 2 * time.untilRestS(sample.fastestRadPerS());
    double atRestS = motionFrames * FrameTime.FRAME_S + rampS;
    return atRestS + 2 * FrameTime.FRAME_S >= active.get().handOverS();
  }

  /** Samples the motion a frame further, its time running evenly from one scaling to the next. */
  private Optional<MotionFailure> sampleAfter(Motion motion, double framesBefore, double before) {
    motionFrames = framesBefore + 0.5 * (before + time.scaling());
    double timeS = atEnd(motion) ? motion.durationS() : motionFrames * FrameTime.FRAME_S;
    return motion.sample(timeS, sample);
  }

  private boolean atEnd(Motion motion) {
    return motionFrames >= motion.durationS() / FrameTime.FRAME_S - FrameTime.ROUNDING;
  }

  private void publish(double scalingPerS) {
    position = Joints.of(sample.position);
    double scaling = time.scaling();
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
    handedOver = false;
    sample.rest();
    time.begin(false);
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
    if (active.isPresent()) {
      time.release();
    }
  }

  void endEarly(MotionTicket ticket) {
    if (owner.isPresent() && owner.get() == ticket) {
      time.release();
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
      time.release();
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
    time.pause(decelerationRadPerS2);
  }

  /** Goes on after {@link #pause} or {@link #halt}. */
  public void resume() {
    time.resume();
  }

  /** Gives up every motion: the arm has been stopped by its brakes and rests elsewhere. */
  public void adopt(Joints positionRad) {
    owner.ifPresent(ticket -> ticket.fail(POWER_LOST));
    pending.ifPresent(next -> next.ticket.fail(POWER_LOST));
    pending = Optional.empty();
    guided = false;
    forget();
    offsets.end();
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
    time.setFraction(fraction);
  }

  /**
   * Puts the target elsewhere, at rest.
   *
   * @throws ScriptError while a motion is under way or the arm is guided by hand
   */
  public void jumpTo(Joints positionRad) throws ScriptError {
    refuseGuided();
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
    return time.fraction();
  }

  /** How fast motion time runs against the clock, 0 to 1. */
  public double scaling() {
    return time.scaling();
  }

  /** Target positions, rad. */
  public Joints positionRad() {
    return offsets.engaged() ? offsets.position() : position;
  }

  /** Where the path is, without what offsets add, rad. */
  public Joints pathPositionRad() {
    return position;
  }

  /** How fast the joints would turn without what offsets add, rad/s. */
  public Joints pathSpeedRadPerS() {
    return speed;
  }

  /** Target speeds, rad/s. */
  public Joints speedRadPerS() {
    return offsets.engaged() ? offsets.speed() : speed;
  }

  /** Target accelerations, rad/s². */
  public Joints accelerationRadPerS2() {
    return offsets.engaged() ? offsets.acceleration() : acceleration;
  }
}
