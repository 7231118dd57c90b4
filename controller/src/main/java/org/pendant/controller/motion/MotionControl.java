package org.pendant.controller.motion;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.value.PoseValue;
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

  /** Slower than this nothing jumps when a motion begins at rest, rad/s. */
  private static final double AT_REST_RAD_PER_S = 1e-4;

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
  private final PathPoint path;

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

  /** Torques of the program drive the arm, and the target follows it. */
  private boolean torqueDriven;

  /** ... and the program has given those for the frame that comes. */
  private boolean torqueGiven;

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
    jointSpeeds = new JointSpeedCheck(arm);
    offsets = new OffsetTarget(arm, jointSpeeds);
    path = new PathPoint(positionRad);
  }

  /**
   * Starts a motion that begins at rest. If the arm still comes to rest from one that nobody waits
   * for, it starts right after that.
   *
   * @throws ScriptError when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket start(MotionPlan plan) throws ScriptError {
    refuseSecondOwner();
    if (endlessly()) {
      settleAtRest();
    }
    MotionTicket ticket = new MotionTicket(this);
    if (active.isPresent()) {
      pending = Optional.of(new Pending(plan, ticket));
    } else {
      begin(plan.from(path.position(), Joints.ZERO), Optional.of(ticket), false);
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
    if (endlessly()) {
      settleAtRest();
    }
    MotionTicket ticket = new MotionTicket(this);
    if (active.isPresent() && !takesOver(move)) {
      handedOver = false;
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
    ticket.stretchedTo(motion.get().stretchedS());
    begin(motion.get(), Optional.of(ticket));
    if (moves) {
      time.goOn();
    } else {
      time.begin(false);
    }
    if (motion.get() instanceof RestOfMove rest && rest.leaving().isPresent()) {
      // nothing to do for this one, and what follows it may blend as if it had not been
      ticket.finish();
      owner = Optional.empty();
      handedOver = true;
    } else if (move.blendRadiusM() > 0) {
      unforeseen = Optional.of(planning);
    }
    return Optional.of(ticket);
  }

  /** Whether a move goes on from the one that is under way, rather than after it. */
  private boolean takesOver(Move move) {
    return handedOver && move.mayFollow(active.orElseThrow().leaving().orElseThrow().move());
  }

  /** Whether something has the arm that no move can blend with, and that nobody waits for. */
  private boolean endlessly() {
    return torqueDriven || (handedOver && active.orElseThrow().leaving().isEmpty());
  }

  /** Gives up what moves the arm without an end, such as speedj, if it does not move it now. */
  private void settleAtRest() throws ScriptError {
    if (path.speed().maxAbsDifference(Joints.ZERO) > AT_REST_RAD_PER_S) {
      String driver = torqueDriven ? "direct_torque" : active.orElseThrow().driver();
      throw new ScriptError(
          "moving",
          driver
              + " has left the arm moving, its fastest joint at "
              + Value.of(path.speed().maxAbsDifference(Joints.ZERO)).text()
              + " rad/s, must be at rest before a move; stopj or stopl brings it to rest");
    }
    torqueDriven = false;
    forget();
  }

  private Planning fromRest(Move move) {
    Joints from = path.position();
    return outlook -> Optional.of(MovePlanner.fromRest(move, from, outlook));
  }

  private Planning joining(Move move) {
    Motion present = active.orElseThrow();
    PathMotion leaving = present.leaving().orElseThrow();
    double leavingS =
        leaving.handOverS() - (present.handOverS() - motionFrames * FrameTime.FRAME_S);
    return outlook -> MovePlanner.blended(leaving, leavingS, move, outlook);
  }

  /** Whether a move has just begun that may be planned anew, knowing what follows it. */
  public boolean wantsOutlook() {
    return unforeseen.isPresent();
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
    begin(plan.from(path.position(), path.speed()), Optional.of(ticket), true);
    return ticket;
  }

  /**
   * Starts a motion that goes on from the present speed and is scaled as moves are; for speeds and
   * servos. What the plan is given is the speed in the motion's own time.
   *
   * @throws ScriptError when it cannot be planned, or another thread's motion is under way
   */
  public MotionTicket goOn(MotionPlan plan) throws ScriptError {
    refuseSecondOwner();
    boolean unscaled = torqueDriven || time.stopping();
    double scaling =
        path.moves() ? time.goingOn(unscaled, jointSpeeds.share(path.speed())) : time.wanted();
    Joints own = scaling > 0 && scaling != 1 ? path.speedInOwnTime(scaling) : path.speed();
    Motion motion = plan.from(path.position(), own);
    MotionTicket ticket = new MotionTicket(this);
    begin(motion, Optional.of(ticket));
    own.copyTo(sample.speed);
    time.goOnAt(scaling);
    return ticket;
  }

  private void refuseSecondOwner() throws ScriptError {
    refuseGuided();
    if (owner.isPresent() || pending.isPresent() || torqueGiven) {
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
    time.setFactor(motion.speedFactor());
    owner = ticket;
    handedOver = false;
    torqueDriven = false;
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
      letGo();
      guided = true;
    }
  }

  private void letGo() {
    takeTargetForPath();
    offsets.end();
    torqueDriven = false;
  }

  /**
   * In the frame that comes torques of the program drive the arm, and {@link #guide} says where the
   * target is. Without another call before the next step the arm comes to rest from there, unless a
   * motion takes it over.
   *
   * @throws ScriptError when a thread's motion is under way, or the arm is guided by hand
   */
  public void giveTorque() throws ScriptError {
    refuseSecondOwner();
    if (!torqueDriven) {
      letGo();
      torqueDriven = true;
    }
    torqueGiven = true;
  }

  /** Whether torques of the program drive the arm; after the step, whether in this frame. */
  public boolean torqueDriven() {
    return torqueDriven;
  }

  /** No torques have come for this frame: the joints stop, as soon as a stop demands. */
  private void endTorques() {
    torqueDriven = false;
    if (path.moves()) {
      begin(new StopJ(path.position(), path.speed(), time.rampRadPerS2()), Optional.empty(), true);
    }
  }

  /** The target is where the arm is that is guided, or driven by torques. */
  public void guide(Joints positionRad, Joints speedRadPerS) {
    path.set(positionRad, speedRadPerS, Joints.ZERO);
  }

  /** The arm is no longer guided: the target comes to rest from where the arm is. */
  public void endGuidance() {
    if (guided) {
      guided = false;
      if (path.moves()) {
        begin(
            new StopJ(path.position(), path.speed(), SCALING_ACCELERATION_RAD_PER_S2),
            Optional.empty(),
            true);
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
    if (torqueGiven) {
      torqueGiven = false;
      framesAtRest = 0;
      return;
    }
    if (torqueDriven) {
      endTorques();
    }
    if (handedOver && !heldInPause()) {
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
      path.rest();
    }
    carryAside();
    framesAtRest =
        speedRadPerS().equals(Joints.ZERO) ? Math.min(framesAtRest + 1, STEADY_FRAMES) : 0;
  }

  /** A motion without an end rests in a pause, and whoever keeps it up goes on after that. */
  private boolean heldInPause() {
    return time.paused() && active.isPresent() && active.get().ending().isPresent();
  }

  /** Nobody has taken the motion over: it ends as it says itself. */
  private void endUncontinued() {
    Optional<MotionPlan> ending = active.flatMap(Motion::ending);
    if (ending.isPresent()) {
      try {
        begin(ending.get().from(path.position(), path.speed()), Optional.empty(), true);
      } catch (ScriptError e) {
        stopBeside(new MotionFailure(e.code(), e.getMessage()));
      }
    }
  }

  private void carryAside() {
    Optional<MotionFailure> failure = offsets.step(path.position(), path.speed());
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
    takeTarget(positionRad(), speedRadPerS());
  }

  /**
   * Ends one offset without a jump: the path is put so that the other offsets carry the TCP to
   * where it is. A motion under way is given up; whoever ends an offset stops the arm with {@link
   * #takeOver}.
   *
   * @throws ScriptError when another thread's motion is under way
   */
  public void endOffset(PathOffset ending) throws ScriptError {
    refuseSecondOwner();
    ending.end();
    if (offsets.engaged()) {
      Optional<OffsetTarget.Rebased> rebased = offsets.rebased(path.position());
      if (rebased.isPresent()) {
        takeTarget(rebased.get().positionRad(), rebased.get().speedRadPerS());
      } else {
        takeTargetForPath();
        offsets.end();
      }
    }
  }

  /** Ends all offsets: what they carry comes to rest, all joints in proportion. */
  public void endOffsets() {
    if (offsets.engaged()) {
      takeTargetForPath();
      begin(
          new StopJ(path.position(), path.speed(), SCALING_ACCELERATION_RAD_PER_S2),
          Optional.empty(),
          true);
    }
    offsets.end();
  }

  /** Whether offsets make the target another than the path. */
  public boolean carried() {
    return offsets.engaged();
  }

  private void takeTarget(Joints target, Joints targetSpeed) {
    Joints targetAcceleration = accelerationRadPerS2();
    owner.ifPresent(ticket -> ticket.fail(PATH_ENDED));
    forget();
    path.set(target, targetSpeed, targetAcceleration);
  }

  private void beginPending(Pending next) {
    pending = Optional.empty();
    try {
      Motion motion = next.plan.from(path.position(), Joints.ZERO);
      next.ticket.stretchedTo(motion.stretchedS());
      begin(motion, Optional.of(next.ticket), false);
    } catch (ScriptError e) {
      next.ticket.fail(new MotionFailure(e.code(), e.getMessage()));
    }
  }

  private void follow(Motion motion) {
    double before = time.scaling();
    double framesBefore = motionFrames;
    time.setFactor(motion.speedFactor());
    time.step(sample.fastestRadPerS());
    path.position().copyTo(previous);
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
      stopBeside(onTheWay(failure.get(), motion));
      return;
    }
    path.follow(sample, time.scaling(), (time.scaling() - before) / FrameTime.FRAME_S);
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
    if (active.isEmpty() || active.get().leaving().isEmpty() || owner.isEmpty()) {
      return handedOver && !endlessly();
    }
    if (time.scaling() == 0) {
      return false;
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

  private void forget() {
    active = Optional.empty();
    owner = Optional.empty();
    handedOver = false;
    sample.rest();
    time.setFactor(1);
    time.begin(false);
  }

  private static MotionFailure onTheWay(MotionFailure failure, Motion motion) {
    return motion
        .waypoint()
        .map(
            goal ->
                new MotionFailure(
                    failure.code(),
                    failure.message() + "; on the way to " + new PoseValue(goal).text()))
        .orElse(failure);
  }

  /** The path cannot be followed: all joints stop from what they do now. */
  private void stopBeside(MotionFailure failure) {
    fault = Optional.of(failure);
    owner.ifPresent(ticket -> ticket.fail(failure));
    pending.ifPresent(next -> next.ticket.fail(failure));
    pending = Optional.empty();
    forget();
    if (!path.moves()) {
      path.rest();
      return;
    }
    begin(
        new StopJ(path.position(), path.speed(), FAULT_DECELERATION_RAD_PER_S2),
        Optional.empty(),
        true);
  }

  /** Lets the arm come to rest on its path and forgets the motion. */
  public void abort() {
    owner = Optional.empty();
    pending = Optional.empty();
    torqueGiven = false;
    handedOver = handedOver && !endlessly();
    if (active.isPresent()) {
      time.release();
    }
  }

  /**
   * Ends a move as {@code abort} does (manual 13.5): one with a blend radius is handed over right
   * away, unless it is still in the blend that it began with; another one comes to rest.
   */
  void endEarly(MotionTicket ticket) {
    if (owner.isPresent() && owner.get() == ticket) {
      Motion present = active.orElseThrow();
      Optional<Motion> cut = present.cutShort(motionFrames * FrameTime.FRAME_S);
      if (cut.isPresent()) {
        begin(cut.get(), Optional.empty());
        ticket.finish();
        handedOver = true;
      } else if (present.leaving().isEmpty() || motionFrames == 0) {
        time.release();
      }
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

  /** Goes on after {@link #pause} or {@link #halt}. */
  public void resume() {
    time.resume();
    offsets.release();
  }

  /** Gives up every motion: the arm has been stopped by its brakes and rests elsewhere. */
  public void adopt(Joints positionRad) {
    owner.ifPresent(ticket -> ticket.fail(POWER_LOST));
    pending.ifPresent(next -> next.ticket.fail(POWER_LOST));
    pending = Optional.empty();
    guided = false;
    torqueDriven = false;
    torqueGiven = false;
    forget();
    offsets.end();
    path.restAt(positionRad);
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
    if (moving() || carried()) {
      throw new ScriptError("robot-in-use", "the arm is moving, must be at rest");
    }
    path.restAt(positionRad);
  }

  /** A new program starts: what stopped the last one is over. */
  public void clearFault() {
    fault = Optional.empty();
  }

  /** What made the arm leave its path and stop. */
  public Optional<MotionFailure> fault() {
    return fault;
  }

  /** Whether a thread waits for a motion that it has started. */
  public boolean owned() {
    return owner.isPresent() || pending.isPresent();
  }

  /** Whether a motion is under way, a paused one included, or torques drive the arm. */
  public boolean moving() {
    return active.isPresent() || pending.isPresent() || torqueDriven;
  }

  /** Whether the motion is held, by a pause or a stop, or is to be held as soon as it begins. */
  public boolean paused() {
    return time.paused();
  }

  /** Whether a move that nobody waits for any more goes on to its waypoint. */
  public boolean arriving() {
    return active.isPresent()
        && owner.isEmpty()
        && !time.releasing()
        && active.get().leaving().isPresent();
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
    return offsets.engaged() ? offsets.position() : path.position();
  }

  /** Where the path is, without what offsets add, rad. */
  public Joints pathPositionRad() {
    return path.position();
  }

  /** How fast the joints would turn without what offsets add, rad/s. */
  public Joints pathSpeedRadPerS() {
    return path.speed();
  }

  /** Target speeds, rad/s. */
  public Joints speedRadPerS() {
    return offsets.engaged() ? offsets.speed() : path.speed();
  }

  /** Target accelerations, rad/s². */
  public Joints accelerationRadPerS2() {
    return offsets.engaged() ? offsets.acceleration() : path.acceleration();
  }
}
