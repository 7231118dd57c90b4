package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Motion control: owns the active trajectory and the setpoint it yields in each frame.
 *
 * <p>The motion's own time advances by the speed scaling times the frame, and slower while a
 * program starts. Pausing, stopping and the speed slider change only that scaling, in ramps, so the
 * path is the same whatever happens on the way. A frame in which nothing begins allocates nothing.
 */
public final class MotionControl {
  /** How fast a change of the scaling may change the speed of the fastest joint, rad/s². */
  public static final double SCALING_ACCELERATION_RAD_PER_S2 = 8;

  /** How fast the arm stops when its path cannot be followed any further, rad/s². */
  public static final double FAULT_DECELERATION_RAD_PER_S2 = 15;

  /** Frames at rest after which the arm counts as steady: 500 ms (manual 16.39). */
  private static final int STEADY_FRAMES = 250;

  private final ControlSource controlSource = new ControlSource();
  private final JointSetpoint jointSetpoint;
  private final PathState path;
  private final OffsetTarget offsets;
  private final ActiveTrajectory activeTrajectory;
  private final TimeScaling time;
  private final MotionQueue motionQueue;
  private final JointNumbers speedBefore = new JointNumbers();

  /** What {@link #accelerationRadPerS2} answers. */
  private final JointNumbers acceleration = new JointNumbers();

  private Optional<MotionFailure> fault = Optional.empty();
  private Optional<MotionFailure> newFault = Optional.empty();
  private int framesAtRest = STEADY_FRAMES;
  private boolean startRamp;

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
    JointSpeedCheck jointSpeeds = new JointSpeedCheck(arm);
    jointSetpoint = new JointSetpoint(arm, positionRad, jointSpeeds);
    path = jointSetpoint.path();
    offsets = jointSetpoint.offsets();
    activeTrajectory = new ActiveTrajectory(limiter, jointSpeeds);
    time = activeTrajectory.time();
    motionQueue = new MotionQueue(activeTrajectory, path, controlSource, jointSpeeds);
  }

  /** How fast the speed on a path may change, in pauses and the like, is limited from now on. */
  public void limitRamps(RampLimiter limiter) {
    activeTrajectory.limitRamps(limiter);
  }

  /**
   * Starts a motion that begins at rest. If the arm still comes to rest from one that no caller
   * waits for, it starts right after that.
   *
   * @throws PlanningException when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket start(MotionPlan plan) throws PlanningException {
    return motionQueue.start(plan);
  }

  /**
   * Starts a move; from rest, or blending with the move before it where that one allows it and has
   * just been handed over.
   *
   * @return empty if the move is left out because its blend overlaps with the one before (manual
   *     15.29)
   * @throws PlanningException when it cannot be planned, or another thread's motion is under way
   */
  public Optional<MotionTicket> start(Move move) throws PlanningException {
    return motionQueue.start(move);
  }

  /** Whether a move has just begun that may be planned anew, knowing what follows it. */
  public boolean wantsOutlook() {
    return motionQueue.wantsOutlook();
  }

  /**
   * Starts a motion that continues from the present speed; for stops. Of an arm at rest it is over
   * at once.
   *
   * @throws PlanningException when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket takeOver(MotionPlan plan) throws PlanningException {
    return motionQueue.takeOver(plan);
  }

  /**
   * Starts a motion that continues from the present speed and is scaled as moves are; for speeds
   * and servos. What the plan is given is the speed in the motion's own time.
   *
   * @throws PlanningException when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket continueWith(MotionPlan plan) throws PlanningException {
    return motionQueue.continueWith(plan);
  }

  /**
   * From now on the arm is guided by hand: a motion that no caller waits for is dropped, and so are
   * offsets; none can start, and {@link #guide} says where the target is.
   *
   * @throws PlanningException when a thread's motion is under way
   */
  public void startGuidance() throws PlanningException {
    if (!controlSource.guided()) {
      motionQueue.refuseSecondOwner();
      letGo();
      controlSource.setGuided(true);
    }
  }

  private void letGo() {
    takeTargetForPath();
    offsets.end();
    controlSource.endTorque();
  }

  /**
   * In the frame that comes torques of the program drive the arm, and {@link #guide} says where the
   * target is. Without another call before the next step the arm comes to rest from there, unless a
   * motion takes it over.
   *
   * @throws PlanningException when a thread's motion is under way, or the arm is guided by hand
   */
  public void giveTorque() throws PlanningException {
    motionQueue.refuseSecondOwner();
    if (!controlSource.torqueDriven()) {
      letGo();
    }
    controlSource.giveTorque();
  }

  /** Whether torques of the program drive the arm; after the step, whether in this frame. */
  public boolean torqueDriven() {
    return controlSource.torqueDriven();
  }

  /** No torques have come for this frame: the joints stop, as soon as a stop demands. */
  private void endTorques() {
    controlSource.endTorque();
    if (path.moves()) {
      motionQueue.stop(time.rampRadPerS2());
    }
  }

  /** The target is where the arm is that is guided, or driven by torques. */
  public void guide(Joints positionRad, Joints speedRadPerS) {
    path.set(positionRad, speedRadPerS, Joints.ZERO);
  }

  /** The arm is no longer guided: the target comes to rest from where the arm is. */
  public void endGuidance() {
    if (controlSource.guided()) {
      controlSource.setGuided(false);
      if (path.moves()) {
        motionQueue.stop(SCALING_ACCELERATION_RAD_PER_S2);
      }
    }
  }

  /** Whether the arm is guided by hand. */
  public boolean guided() {
    return controlSource.guided();
  }

  /** Gives the next target; step 3 of a frame. */
  public void step() {
    time.stepStartRamp();
    speedBefore.set(jointSetpoint.speed());
    if (controlSource.guided() || controlSource.useTorque()) {
      acceleration.setZero();
      framesAtRest = 0;
      return;
    }
    if (controlSource.torqueDriven()) {
      endTorques();
    }
    Optional<MotionFailure> unended = motionQueue.settle();
    if (unended.isPresent()) {
      stopBeside(unended.get());
    }
    Optional<MotionFailure> lost = motionQueue.advance();
    if (lost.isPresent()) {
      stopAtOnce(lost.get());
    }
    carryAside();
    acceleration.setRate(speedBefore, jointSetpoint.speed());
    framesAtRest = jointSetpoint.speed().isZero() ? Math.min(framesAtRest + 1, STEADY_FRAMES) : 0;
  }

  private void carryAside() {
    Optional<MotionFailure> failure = offsets.step(path);
    if (failure.isPresent()) {
      takeTargetForPath();
      offsets.end();
      stopAtOnce(failure.get());
    }
  }

  /** The stop begins in the frame that could not be: the target does not stand still meanwhile. */
  private void stopAtOnce(MotionFailure failure) {
    stopBeside(failure);
    Optional<MotionFailure> again = motionQueue.advance();
    if (again.isPresent()) {
      stopBeside(again.get());
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

  private static MotionFailure pathEnded() {
    return new MotionFailure("path-ended", text("pathEnded"));
  }

  private static MotionFailure powerLost() {
    return new MotionFailure("power-off", text("powerLost"));
  }

  /**
   * From now on the path is where the target is, so that an offset can end without a jump. A motion
   * under way is given up; the caller that ends an offset stops the arm with {@link #takeOver}.
   */
  public void takeTargetForPath() {
    motionQueue.giveUp(MotionControl::pathEnded);
    jointSetpoint.takeForPath();
  }

  /**
   * Ends one offset without a jump: the path is put so that the other offsets carry the TCP to
   * where it is. A motion under way is given up; the caller that ends an offset stops the arm with
   * {@link #takeOver}.
   *
   * @throws PlanningException when another thread's motion is under way
   */
  public void endOffset(PathOffset ending) throws PlanningException {
    motionQueue.refuseSecondOwner();
    ending.end();
    if (offsets.engaged()) {
      motionQueue.giveUp(MotionControl::pathEnded);
      jointSetpoint.rebase();
    }
  }

  /** Ends all offsets: what they carry comes to rest, all joints in proportion. */
  public void endOffsets() {
    if (offsets.engaged()) {
      takeTargetForPath();
      motionQueue.stop(SCALING_ACCELERATION_RAD_PER_S2);
    }
    offsets.end();
  }

  /** Whether offsets make the target another than the path. */
  public boolean carried() {
    return offsets.engaged();
  }

  /**
   * Whether an arm that slows down from now on comes to rest after the point where its move is
   * handed over, so that the caller has to say before where it leads on.
   */
  public boolean handsOverBeforeRest() {
    return motionQueue.handsOverBeforeRest();
  }

  /** The path cannot be followed: all joints stop from what they do now. */
  private void stopBeside(MotionFailure failure) {
    fault = Optional.of(failure);
    newFault = fault;
    motionQueue.giveUpAll(() -> failure);
    if (path.moves()) {
      motionQueue.stop(FAULT_DECELERATION_RAD_PER_S2);
    } else {
      path.rest();
    }
  }

  /** Lets the arm come to rest on its path and forgets the motion. */
  public void abort() {
    controlSource.withdrawTorque();
    motionQueue.abort();
    if (controlSource.torqueDriven()) {
      endTorques();
    }
  }

  /** Comes to rest on the path and keeps the motion for {@link #resume}. */
  public void pause() {
    if (!time.paused()) {
      time.pause(SCALING_ACCELERATION_RAD_PER_S2);
    }
  }

  /**
   * As {@link #pause}, for stops that must be shorter; what offsets carry comes to rest as well.
   *
   * @param decelerationRadPerS2 of the fastest joint, above 0
   */
  public void halt(double decelerationRadPerS2) {
    time.pause(decelerationRadPerS2);
    offsets.hold(decelerationRadPerS2);
  }

  /** Continues after {@link #pause} or {@link #halt}. */
  public void resume() {
    time.resume();
    offsets.release();
  }

  /** Gives up every motion: the arm has been stopped by its brakes and rests elsewhere. */
  public void adopt(Joints positionRad) {
    controlSource.clear();
    motionQueue.giveUpAll(MotionControl::powerLost);
    offsets.end();
    path.restAt(positionRad);
    acceleration.setZero();
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
   * @throws PlanningException while a motion is under way or the arm is guided by hand
   */
  public void jumpTo(Joints positionRad) throws PlanningException {
    motionQueue.refuseGuided();
    if (moving() || carried()) {
      throw new PlanningException("robot-in-use", text("notAtRest"));
    }
    path.restAt(positionRad);
    acceleration.setZero();
  }

  /** Whether programs have a {@link StartRamp}; at first they have none. */
  public void setStartRamp(boolean on) {
    startRamp = on;
  }

  /**
   * A new program starts, with its start ramp if programs have one. An arm that still moves from
   * the program before continues as it was.
   */
  public void programStarted() {
    clearFault();
    if (startRamp && !path.moves()) {
      time.beginStartRamp();
    }
  }

  /** What stopped the last motion is over. */
  public void clearFault() {
    fault = Optional.empty();
    newFault = Optional.empty();
  }

  /** What made the arm leave its path since this was last asked; empty if nothing did. */
  public Optional<MotionFailure> takeNewFault() {
    Optional<MotionFailure> taken = newFault;
    newFault = Optional.empty();
    return taken;
  }

  /** What made the arm leave its path and stop. */
  public Optional<MotionFailure> fault() {
    return fault;
  }

  /** Whether a thread waits for a motion that it has started. */
  public boolean owned() {
    return motionQueue.owned();
  }

  /** Whether a motion is under way, a paused one included, or torques drive the arm. */
  public boolean moving() {
    return motionQueue.moving() || controlSource.torqueDriven();
  }

  /** Whether a pause or a stop keeps the motion at rest, or will as soon as it begins. */
  public boolean paused() {
    return time.paused();
  }

  /** Whether a move that no caller waits for any more continues to its waypoint. */
  public boolean arriving() {
    return motionQueue.arriving();
  }

  /** Whether the target has rested for 500 ms. */
  public boolean steady() {
    return framesAtRest >= STEADY_FRAMES;
  }

  /** Where the active move takes the TCP, in the base frame. */
  public Optional<Pose> waypoint() {
    return activeTrajectory.active().flatMap(Motion::waypoint);
  }

  /** The speed slider, 0 to 1. */
  public double speedFraction() {
    return time.fraction();
  }

  /** How fast motion time runs against the clock, 0 to 1; the start ramp does not show in it. */
  public double scaling() {
    return time.scaling();
  }

  /** Target positions, rad. */
  public Joints positionRad() {
    return jointSetpoint.position().joints();
  }

  /** Writes target positions, rad, into six numbers; allocates nothing. */
  public void copyPositionRad(double[] q) {
    System.arraycopy(jointSetpoint.position().numbers(), 0, q, 0, Joints.COUNT);
  }

  /** Takes over target positions, rad; allocates nothing. */
  public void readPositionRad(JointNumbers target) {
    target.set(jointSetpoint.position());
  }

  /** Takes over target speeds, rad/s; allocates nothing. */
  public void readSpeedRadPerS(JointNumbers target) {
    target.set(jointSetpoint.speed());
  }

  /** Takes over {@link #accelerationRadPerS2}; allocates nothing. */
  public void readAccelerationRadPerS2(JointNumbers target) {
    target.set(acceleration);
  }

  /** Where the path is, without what offsets add, rad. */
  public Joints pathPositionRad() {
    return path.position().joints();
  }

  /** How fast the joints would turn without what offsets add, rad/s. */
  public Joints pathSpeedRadPerS() {
    return path.speed().joints();
  }

  /** Target speeds, rad/s. */
  public Joints speedRadPerS() {
    return jointSetpoint.speed().joints();
  }

  /** Whether a target speed is not 0. */
  public boolean turning() {
    return !jointSetpoint.speed().isZero();
  }

  /**
   * Target accelerations, rad/s²: by how much the target speeds have changed in the last frame over
   * its time, as controllers publish them.
   */
  public Joints accelerationRadPerS2() {
    return acceleration.joints();
  }
}
