package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

/** Blends that nobody would program on purpose. */
@Tag("slow")
final class OddBlendTest {
  private static final double FRAME_S = FrameTime.FRAME_S;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);
  private static final Pose OTHER_TCP = new Pose(0.05, 0.02, 0.15, 0.3, 0, 0);

  /** More than the lines here need; a jump of speed is far above. */
  private static final double MAX_RAD_PER_S2 = 25;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final Pose home = forward.tcpPose(READY, TCP);
  private final MotionControl control = new MotionControl(arm, READY);
  private int frames;
  private double hardest;
  private double nearest = Double.POSITIVE_INFINITY;
  private Pose watched = home;

  private Pose at(double x, double y, double z) {
    return Poses.add(home, new Pose(x, y, z, 0, 0, 0));
  }

  private Move line(Pose goal, double r, double ramp) {
    return line(goal, new MoveLimits(1.2, 0.25, 0), r, ramp, TCP);
  }

  private Move line(Pose goal, MoveLimits limits, double r, double ramp, Pose tcp) {
    return new Move(
        from -> Routes.line(arm, from, forward.tcpPose(from, tcp), goal, tcp), limits, r, ramp);
  }

  private Move joints(Joints goal, double r, double ramp) {
    return new Move(
        from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP),
        new MoveLimits(1.4, 1.05, 0),
        r,
        ramp);
  }

  private void step() {
    Joints before = control.positionRad();
    Joints speed = control.speedRadPerS();
    control.step();
    frames++;
    hardest = Math.max(hardest, control.speedRadPerS().maxAbsDifference(speed) / FRAME_S);
    double moved = control.positionRad().maxAbsDifference(before);
    assertTrue(moved <= Math.PI * FRAME_S * (1 + 1e-9), "moved " + moved);
    nearest =
        Math.min(
            nearest, Poses.pointDistance(forward.tcpPose(control.positionRad(), TCP), watched));
    assertTrue(frames < 100_000, "endless");
    assertEquals(Optional.empty(), control.fault());
  }

  private boolean go(Move move, List<Move> foreseen) throws PlanningException {
    Optional<MotionTicket> ticket = control.start(move);
    ticket.ifPresent(started -> started.outlook(foreseen));
    while (ticket.isPresent() && !ticket.get().finished()) {
      step();
    }
    return ticket.isPresent();
  }

  /** Each move knows those that follow it. */
  private void chain(Move... moves) throws PlanningException {
    for (int i = 0; i < moves.length; i++) {
      go(moves[i], List.of(moves).subList(i + 1, moves.length));
    }
    rest();
  }

  private void rest() {
    while (control.moving()) {
      step();
    }
    assertEquals(Joints.ZERO, control.speedRadPerS());
    assertTrue(hardest <= MAX_RAD_PER_S2, "acceleration " + hardest);
  }

  private void assertEndsAt(Pose goal) {
    assertEquals(0, Poses.distance(forward.tcpPose(control.positionRad(), TCP), goal), 1e-9);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void aRadiusLargerThanAllSegmentsIsNoHarm(double ramp) throws PlanningException {
    Pose end = at(0.1, 0.1, 0);
    chain(
        line(at(0.05, 0, 0), 1, ramp),
        line(at(0.05, 0.05, 0), 1, ramp),
        line(at(0.1, 0.05, 0), 1, ramp),
        line(end, 0, ramp));
    assertEndsAt(end);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void movesToWhereTheArmIsMayBlend(double ramp) throws PlanningException {
    Pose middle = at(0.1, 0, 0);
    Pose end = at(0.1, 0.1, 0);
    chain(
        line(home, 0.02, ramp),
        line(middle, 0.02, ramp),
        line(middle, 0.02, ramp),
        joints(READY, 0.02, ramp),
        joints(READY, 0.02, ramp),
        line(end, 0.02, ramp),
        line(end, 0, ramp));
    assertEndsAt(end);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void turnsOnTheSpotBlend(double ramp) throws PlanningException {
    Pose first = Poses.trans(home, new Pose(0, 0, 0, 0.4, 0, 0));
    Pose second = Poses.trans(first, new Pose(0, 0, 0, 0, 0.4, 0));
    chain(line(first, 0.02, ramp), line(second, 0.02, ramp), line(home, 0, ramp));
    assertEndsAt(home);
    assertTrue(nearest < 1e-9, "left the spot by " + nearest);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void aReversalComesNearlyToRest(double ramp) throws PlanningException {
    watched = at(0.2, 0, 0);
    chain(line(at(0.2, 0, 0), 0.03, ramp), line(home, 0, ramp));
    assertEndsAt(home);
    assertTrue(nearest > 1e-3 && nearest < 0.03, "passes at " + nearest);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void aTenthOfAMillimetreIsKept(double ramp) throws PlanningException {
    watched = at(0.1, 0, 0);
    chain(line(watched, 1e-4, ramp), line(at(0.1, 0.1, 0), 0, ramp));
    assertTrue(nearest < 1e-4, "passes at " + nearest);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void crawlingBlendsTakeTheirTime(double ramp) throws PlanningException {
    MoveLimits slow = new MoveLimits(1.2, 0.001, 0);
    Pose end = at(0.005, 0.005, 0);
    chain(line(at(0.005, 0, 0), slow, 0.002, ramp, TCP), line(end, slow, 0, ramp, TCP));
    assertEndsAt(end);
    // the corner is cut by less than the radius on each side
    assertTrue(frames * FRAME_S > 6 && frames * FRAME_S < 11, frames + " frames");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void theToolMayChangeBetweenMoves(double ramp) throws PlanningException {
    Pose end = Poses.add(forward.tcpPose(READY, OTHER_TCP), new Pose(0.1, 0.1, 0, 0, 0, 0));
    MoveLimits limits = new MoveLimits(1.2, 0.25, 0);
    chain(line(at(0.1, 0, 0), 0.03, ramp), line(end, limits, 0, ramp, OTHER_TCP));
    Pose reached = forward.tcpPose(control.positionRad(), OTHER_TCP);
    assertEquals(0, Poses.distance(reached, end), 1e-9);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void movesWithADurationBlendWithoutAnAcceleration(double ramp) throws PlanningException {
    Pose end = at(0.2, 0.2, 0);
    chain(
        line(at(0.2, 0, 0), new MoveLimits(0, 0, 1), 0.03, ramp, TCP),
        line(at(0.2, 0.1, 0), new MoveLimits(0, 0, 0.5), 0.03, ramp, TCP),
        line(end, new MoveLimits(0, 0, 0.5), 0, ramp, TCP));
    assertEndsAt(end);
    assertTrue(frames * FRAME_S < 2.5, frames + " frames");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void durationsThatTheArmCannotKeepAreStretched(double ramp) throws PlanningException {
    Joints far = READY.with(0, 1);
    Move.PathPlanner there = from -> Routes.joints(arm, from, far, forward.tcpPose(far, TCP), TCP);
    Move.PathPlanner back = from -> Routes.joints(arm, from, READY, home, TCP);
    MoveLimits hasty = new MoveLimits(1.4, 1.05, 0.05);
    MotionTicket first = control.start(new Move(there, hasty, 0.05, ramp)).orElseThrow();
    assertTrue(first.stretchedS() > 0.3, "stretched to " + first.stretchedS());
    while (!first.finished()) {
      step();
    }
    go(new Move(back, hasty, 0, ramp), List.of());
    assertEquals(READY, control.positionRad());
    assertTrue(hardest <= 40 * (1 + 1e-9), "acceleration " + hardest);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void aMoveThatWasNotForeseenIsBlendedAsGentlyAsItCanBe(double ramp) throws PlanningException {
    Move first = line(at(0.2, 0, 0), 0.01, ramp);
    go(first, List.of(line(at(0.4, 0, 0), 0, ramp)));
    Pose back = at(0.1, 0.05, 0);
    go(line(back, 0, ramp), List.of());
    assertEndsAt(back);
    // the change of 0.25 m/s within 20 mm at that speed; the arm here turns 3 rad for a metre
    assertTrue(hardest < 3 * 1.5 * 0.25 * 0.25 / 0.02 * 2, "acceleration " + hardest);
  }

  @Test
  void aMoveThatWasForeseenAndDoesNotComeEndsInItsWaypoint() throws PlanningException {
    Pose corner = at(0.2, 0, 0);
    go(line(corner, 0.01, 0), List.of(line(at(0.4, 0, 0), 0, 0)));
    while (control.moving()) {
      step();
    }
    assertEndsAt(corner);
  }

  @Test
  void aMoverThatIsKilledInABlendRestsOnThePathOfTheBlend() throws PlanningException {
    Move first = line(at(0.2, 0, 0), 0.05, 0);
    Move second = line(at(0.2, 0.2, 0), 0, 0);
    go(first, List.of(second));
    MotionTicket ticket = control.start(second).orElseThrow();
    for (int k = 0; k < 60; k++) {
      step();
    }
    ticket.cancel();
    rest();
    Pose stopped = forward.tcpPose(control.positionRad(), TCP);
    assertTrue(stopped.x() < home.x() + 0.2 && stopped.y() > home.y(), stopped.toString());
    assertFalse(ticket.finished());
  }

  @Test
  void stopjTakesOverInABlend() throws PlanningException {
    Move first = line(at(0.2, 0, 0), 0.05, 0);
    Move second = line(at(0.2, 0.2, 0), 0, 0);
    go(first, List.of(second));
    MotionTicket ticket = control.start(second).orElseThrow();
    for (int k = 0; k < 60; k++) {
      step();
    }
    ticket.cancel();
    double fastest = control.speedRadPerS().maxAbsDifference(Joints.ZERO);
    MotionTicket stop = control.takeOver((q, qd) -> new StopJ(q, qd, 3));
    int begun = frames;
    while (!stop.finished()) {
      step();
    }
    assertEquals(Math.ceil(fastest / 3 / FRAME_S), frames - begun);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.08})
  void abortHandsAMoveWithARadiusOverAtOnce(double ramp) throws PlanningException {
    Move first = line(at(0.3, 0, 0), 0.02, ramp);
    MotionTicket ticket = control.start(first).orElseThrow();
    for (int k = 0; k < 250; k++) {
      step();
    }
    double x = forward.tcpPose(control.positionRad(), TCP).x() - home.x();
    ticket.endEarly();
    assertTrue(ticket.finished());
    Pose end = at(0.1, 0.2, 0);
    hardest = 0;
    go(line(end, 0, ramp), List.of());
    rest();
    assertEndsAt(end);
    assertTrue(x < 0.15, "aborted at " + x);
  }

  @Test
  void abortWithNothingToFollowComesToRestOnThePath() throws PlanningException {
    MotionTicket ticket = control.start(line(at(0.3, 0, 0), 0.02, 0)).orElseThrow();
    for (int k = 0; k < 250; k++) {
      step();
    }
    double x = forward.tcpPose(control.positionRad(), TCP).x() - home.x();
    ticket.endEarly();
    rest();
    Pose stopped = forward.tcpPose(control.positionRad(), TCP);
    // twice the way that the move's own deceleration needs
    assertEquals(x + 0.25 * 0.25 / 1.2, stopped.x() - home.x(), 1e-3);
    assertEquals(home.y(), stopped.y(), 1e-9);
  }

  @Test
  void abortIsIgnoredInTheBlendThatAMoveBeganWith() throws PlanningException {
    Move first = line(at(0.2, 0, 0), 0.05, 0);
    Move second = line(at(0.2, 0.2, 0), 0.02, 0);
    go(first, List.of(second));
    MotionTicket ticket = control.start(second).orElseThrow();
    step();
    ticket.endEarly();
    assertFalse(ticket.finished());
    while (!ticket.finished()) {
      step();
    }
    rest();
    assertEndsAt(at(0.2, 0.2, 0));
  }

  @Test
  void aPauseRightBeforeAHandOverIsOverWhenTheArmRests() throws PlanningException {
    Move move = line(at(0.2, 0, 0), 0.05, 0);
    MotionTicket whole = control.start(move).orElseThrow();
    while (!whole.finished()) {
      step();
    }
    int handedOver = frames;
    for (int pauseAt = handedOver - 60; pauseAt < handedOver; pauseAt++) {
      MotionControl paused = new MotionControl(arm, READY);
      paused.start(move);
      for (int k = 0; k < pauseAt; k++) {
        paused.step();
      }
      paused.pause();
      for (int k = 0; k < 400; k++) {
        paused.step();
      }
      assertFalse(paused.handsOverBeforeRest(), "paused in frame " + pauseAt);
    }
  }
}
