package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.models.arm.Joints;
import org.pendant.models.text.FloatText;

/**
 * Motion queue: the moves that wait for the active trajectory, when it is handed over, and how the
 * next one begins: from rest, with a blend, or at the present speed.
 */
final class MotionQueue {
  /** Slower than this nothing jumps when a motion begins at rest, rad/s. */
  private static final double AT_REST_RAD_PER_S = 1e-4;

  private final ActiveTrajectory activeTrajectory;
  private final TimeScaling time;
  private final PathState path;
  private final ControlSource controlSource;
  private final JointSpeedCheck jointSpeeds;
  private Optional<MotionTicket> owner = Optional.empty();
  private Optional<Pending> pending = Optional.empty();

  /** The caller that asked for the motion continues now, and may blend into another. */
  private boolean handedOver;

  /** Plans a move that has not begun to move, as often as more becomes known of what follows it. */
  private interface Planning {
    Optional<Motion> knowing(List<Move> outlook) throws PlanningException;
  }

  /** The plan of a move that has just begun, and that would gain from an outlook. */
  private Optional<Planning> unforeseen = Optional.empty();

  /** Why the next frame cannot lead on, found when a motion was to take over. */
  private Optional<MotionFailure> lost = Optional.empty();

  private record Pending(MotionPlan plan, MotionTicket ticket) {}

  /** Whether the pending move would gain from an outlook, and what is known of it. */
  private boolean pendingUnforeseen;

  private List<Move> pendingOutlook = List.of();

  /** Nothing is under way. */
  MotionQueue(
      ActiveTrajectory activeTrajectory,
      PathState path,
      ControlSource controlSource,
      JointSpeedCheck jointSpeeds) {
    this.activeTrajectory = activeTrajectory;
    time = activeTrajectory.time();
    this.path = path;
    this.controlSource = controlSource;
    this.jointSpeeds = jointSpeeds;
  }

  /** See {@link MotionControl#start(MotionPlan)}. */
  MotionTicket start(MotionPlan plan) throws PlanningException {
    refuseSecondOwner();
    if (endlessly()) {
      settleAtRest();
    }
    MotionTicket ticket = new MotionTicket(this);
    if (activeTrajectory.present()) {
      pending = Optional.of(new Pending(plan, ticket));
    } else {
      begin(plan.from(path.position().joints(), Joints.ZERO), Optional.of(ticket), false);
    }
    return ticket;
  }

  /** See {@link MotionControl#start(Move)}. */
  Optional<MotionTicket> start(Move move) throws PlanningException {
    refuseSecondOwner();
    if (endlessly()) {
      settleAtRest();
    }
    MotionTicket ticket = new MotionTicket(this);
    if (activeTrajectory.present() && !takesOver(move)) {
      handedOver = false;
      MotionPlan plan = (from, atSpeed) -> MovePlanner.fromRest(move, from, pendingOutlook);
      pending = Optional.of(new Pending(plan, ticket));
      pendingOutlook = List.of();
      pendingUnforeseen = move.blendRadiusM() > 0;
      return Optional.of(ticket);
    }
    Planning planning = handedOver ? joining(move) : fromRest(move);
    Optional<Motion> motion;
    try {
      motion = planning.knowing(List.of());
    } catch (PlanningException e) {
      lose(e, ticket);
      return Optional.of(ticket);
    }
    if (motion.isEmpty()) {
      return Optional.empty();
    }
    boolean moves = handedOver;
    ticket.stretchedTo(motion.get().stretchedS());
    begin(motion.get(), Optional.of(ticket));
    if (moves) {
      time.continueScaling();
    } else {
      time.begin(false);
    }
    if (motion.get() instanceof RemainderMotion rest && rest.leaving().isPresent()) {
      // nothing to do for this one, and what follows it may blend as if it had not been
      ticket.finish();
      owner = Optional.empty();
      handedOver = true;
    } else if (move.blendRadiusM() > 0) {
      unforeseen = Optional.of(planning);
    }
    return Optional.of(ticket);
  }

  /** Whether a move continues from the one that is under way, rather than after it. */
  private boolean takesOver(Move move) {
    return handedOver
        && !time.releasing()
        && move.mayFollow(activeTrajectory.motion().leaving().orElseThrow().move());
  }

  /** Whether something has the arm that no move can blend with, and that no caller waits for. */
  private boolean endlessly() {
    return controlSource.torqueDriven()
        || (handedOver && activeTrajectory.motion().leaving().isEmpty());
  }

  /** Gives up what moves the arm without an end, such as speedj, if it does not move it now. */
  private void settleAtRest() throws PlanningException {
    double fastest = path.speed().largest();
    if (fastest > AT_REST_RAD_PER_S) {
      String driver =
          controlSource.torqueDriven() ? "direct_torque" : activeTrajectory.motion().driver();
      throw new PlanningException("moving", text("leftMoving", driver, FloatText.of(fastest)));
    }
    controlSource.endTorque();
    forget();
  }

  private Planning fromRest(Move move) {
    Joints from = path.position().joints();
    return outlook -> Optional.of(MovePlanner.fromRest(move, from, outlook));
  }

  private Planning joining(Move move) {
    Motion present = activeTrajectory.motion();
    PathMotion leaving = present.leaving().orElseThrow();
    double leavingS = leaving.handOverS() - (present.handOverS() - activeTrajectory.atS());
    return outlook -> MovePlanner.blended(leaving, leavingS, move, outlook);
  }

  /** See {@link MotionControl#wantsOutlook}. */
  boolean wantsOutlook() {
    return unforeseen.isPresent() || pendingUnforeseen;
  }

  boolean wantsOutlook(MotionTicket ticket) {
    return pendingUnforeseen
        ? pending.isPresent() && pending.get().ticket == ticket
        : unforeseen.isPresent() && owner.isPresent() && owner.get() == ticket;
  }

  void outlook(MotionTicket ticket, List<Move> next) {
    if (pendingUnforeseen && wantsOutlook(ticket)) {
      pendingOutlook = List.copyOf(next);
    } else if (wantsOutlook(ticket) && !next.isEmpty()) {
      try {
        activeTrajectory.replace(unforeseen.get().knowing(next));
      } catch (PlanningException e) {
        // the next move cannot be made; it will say so itself when its turn comes
      }
    }
    unforeseen = Optional.empty();
    pendingUnforeseen = false;
  }

  /** See {@link MotionControl#takeOver}. */
  MotionTicket takeOver(MotionPlan plan) throws PlanningException {
    refuseSecondOwner();
    MotionTicket ticket = new MotionTicket(this);
    if (path.speed().largest() > AT_REST_RAD_PER_S) {
      begin(plan.from(path.position().joints(), path.speed().joints()), Optional.of(ticket), true);
    } else {
      controlSource.endTorque();
      forget();
      ticket.finish();
    }
    return ticket;
  }

  /** See {@link MotionControl#continueWith}. */
  MotionTicket continueWith(MotionPlan plan) throws PlanningException {
    refuseSecondOwner();
    boolean unscaled = controlSource.torqueDriven() || time.stopping();
    if (unscaled && path.moves()) {
      time.endStartRamp();
    }
    double scaling =
        path.moves()
            ? time.continuedScaling(unscaled, jointSpeeds.share(path.speed()))
            : time.wanted();
    double rate = scaling * time.startSoFar();
    Joints own = rate > 0 && rate != 1 ? path.speedInOwnTime(rate) : path.speed().joints();
    MotionTicket ticket = new MotionTicket(this);
    Motion motion;
    try {
      motion = plan.from(path.position().joints(), own);
    } catch (PlanningException e) {
      lose(e, ticket);
      return ticket;
    }
    double overrun = handedOver ? activeTrajectory.overrun() : 0;
    begin(motion, Optional.of(ticket));
    activeTrajectory.takeOff(overrun);
    activeTrajectory.continueAt(own, scaling);
    return ticket;
  }

  /**
   * The arm cannot continue where a motion was to take over: that ends in the next frame.
   *
   * @throws PlanningException {@code why}, if the arm could continue but not as it was asked to
   */
  private void lose(PlanningException why, MotionTicket ticket) throws PlanningException {
    if (!MotionFailure.isOfPath(why.failure().code())) {
      throw why;
    }
    lost = Optional.of(why.failure());
    owner = Optional.of(ticket);
  }

  /** Refuses when a thread's motion is under way, or the arm is guided by hand. */
  void refuseSecondOwner() throws PlanningException {
    refuseGuided();
    if (owner.isPresent() || pending.isPresent() || controlSource.torqueGiven()) {
      throw new PlanningException("robot-in-use", text("otherThread"));
    }
  }

  void refuseGuided() throws PlanningException {
    if (controlSource.guided()) {
      throw new PlanningException("freedrive", text("inFreedrive"));
    }
  }

  private void begin(Motion motion, Optional<MotionTicket> ticket, boolean stop) {
    begin(motion, ticket);
    time.begin(stop);
  }

  private void begin(Motion motion, Optional<MotionTicket> ticket) {
    activeTrajectory.begin(motion);
    owner = ticket;
    handedOver = false;
    controlSource.endTorque();
    unforeseen = Optional.empty();
  }

  /** All joints stop from what they do now; no caller waits for it. */
  void stop(double decelerationRadPerS2) {
    Joints from = path.position().joints();
    begin(new StopJ(from, path.speed().joints(), decelerationRadPerS2), Optional.empty(), true);
  }

  /**
   * Ends what has been handed over and no move has taken over; before a frame continues.
   *
   * @return why it does not end as it should
   */
  Optional<MotionFailure> settle() {
    Optional<MotionFailure> failure = lost;
    lost = Optional.empty();
    if (failure.isEmpty() && handedOver && !heldInPause()) {
      handedOver = false;
      failure = endUncontinued();
    }
    unforeseen = Optional.empty();
    pendingUnforeseen = false;
    return failure;
  }

  /**
   * A motion without an end rests in a pause, and the client that keeps it up continues after that.
   */
  private boolean heldInPause() {
    return time.paused()
        && activeTrajectory.present()
        && activeTrajectory.motion().ending().isPresent();
  }

  /** No move has taken the motion over: it ends as it says itself. */
  private Optional<MotionFailure> endUncontinued() {
    Optional<MotionPlan> ending = activeTrajectory.active().flatMap(Motion::ending);
    if (ending.isPresent()) {
      try {
        Joints from = path.position().joints();
        begin(ending.get().from(from, path.speed().joints()), Optional.empty(), true);
      } catch (PlanningException e) {
        return Optional.of(e.failure());
      }
    }
    return Optional.empty();
  }

  /**
   * Goes a frame on.
   *
   * @return why the path cannot be followed
   */
  Optional<MotionFailure> advance() {
    if (!activeTrajectory.present() && pending.isPresent()) {
      beginPending(pending.get());
    }
    if (!activeTrajectory.present()) {
      path.rest();
      return Optional.empty();
    }
    Optional<MotionFailure> failure = activeTrajectory.advance(path);
    if (failure.isPresent()) {
      return failure;
    }
    if (activeTrajectory.ended()) {
      finish();
      forget();
    } else if (owner.isPresent() && activeTrajectory.handOverDue()) {
      finish();
      owner = Optional.empty();
      handedOver = true;
    }
    return failure;
  }

  private void beginPending(Pending next) {
    pending = Optional.empty();
    try {
      Motion motion = next.plan.from(path.position().joints(), Joints.ZERO);
      next.ticket.stretchedTo(motion.stretchedS());
      begin(motion, Optional.of(next.ticket), false);
    } catch (PlanningException e) {
      next.ticket.fail(e.failure());
    }
  }

  private void finish() {
    if (owner.isPresent()) {
      owner.get().finish();
    }
  }

  /** See {@link MotionControl#handsOverBeforeRest}. */
  boolean handsOverBeforeRest() {
    if (!activeTrajectory.present()
        || activeTrajectory.motion().leaving().isEmpty()
        || owner.isEmpty()) {
      return handedOver && !endlessly();
    }
    return activeTrajectory.handsOverBeforeRest();
  }

  /** Gives up the motion under way; a thread that waits for it is told why. */
  void giveUp(Supplier<MotionFailure> reason) {
    owner.ifPresent(ticket -> ticket.fail(reason.get()));
    forget();
  }

  /** Gives up the motion under way and the one after it. */
  void giveUpAll(Supplier<MotionFailure> reason) {
    pending.ifPresent(next -> next.ticket.fail(reason.get()));
    pending = Optional.empty();
    giveUp(reason);
  }

  private void forget() {
    activeTrajectory.forget();
    owner = Optional.empty();
    handedOver = false;
  }

  /** See {@link MotionControl#abort}. */
  void abort() {
    owner = Optional.empty();
    pending = Optional.empty();
    handedOver = handedOver && !endlessly();
    if (activeTrajectory.present()) {
      time.release();
    }
  }

  /** Whether a thread waits for a motion. */
  boolean owned() {
    return owner.isPresent() || pending.isPresent();
  }

  /** Whether there is a motion, or one that begins when the arm is at rest. */
  boolean moving() {
    return activeTrajectory.present() || pending.isPresent();
  }

  /** See {@link MotionControl#arriving}. */
  boolean arriving() {
    return activeTrajectory.present()
        && owner.isEmpty()
        && !time.releasing()
        && activeTrajectory.motion().leaving().isPresent();
  }

  /**
   * Ends a move as {@code abort} does (manual 13.5): one with a blend radius is handed over right
   * away, unless it is still in the blend that it began with; another one comes to rest.
   */
  void endEarly(MotionTicket ticket) {
    if (owner.isPresent() && owner.get() == ticket) {
      Optional<Motion> cut = activeTrajectory.cutShort();
      if (cut.isPresent()) {
        begin(cut.get(), Optional.empty());
        ticket.finish();
        handedOver = true;
      } else if (activeTrajectory.motion().leaving().isEmpty() || activeTrajectory.unmoved()) {
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
}
