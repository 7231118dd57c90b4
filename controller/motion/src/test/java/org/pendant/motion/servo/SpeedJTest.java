package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.Joints;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PathLimiter;
import org.pendant.motion.PlanningException;
import org.pendant.motion.StopJ;

class SpeedJTest {
  private static final Joints TURNING = new Joints(0.2, -0.4, 0.1, 0.05, 0, 0.3);
  private static final Joints SPIN = new Joints(0, 0, 0, 0, 0, 0.2);

  /** The way of 1 s of {@link #SPIN}, less half of the 5 ms in which the joint speeds up. */
  private static final double SPUN_RAD = 0.2 * (1 - 0.0025);

  private static final OptionalDouble UNTIL_REACHED = OptionalDouble.empty();

  private final Rig rig = new Rig();

  private MotionPlan speed(Joints wanted, double acceleration, double returnS) {
    return rig.servoing.speedJ(wanted, acceleration, OptionalDouble.of(returnS));
  }

  @Test
  void returnsWhenTheSpeedIsReached() throws PlanningException {
    int frames = rig.run(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
    assertEquals(400, frames, "0.4 rad/s by 0.5 rad/s² take 0.8 s");
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-12);
    assertEquals(0.5, rig.largestAcceleration, 1e-9);
    assertEquals(Rig.READY.q1() - 0.16, rig.control.positionRad().q1(), 1e-12);
  }

  @Test
  void allJointsArriveAtTheSameMoment() throws PlanningException {
    rig.control.continueWith(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
    rig.steps(200);
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(TURNING.get(i) / 2, rig.control.speedRadPerS().get(i), 1e-12);
    }
  }

  @Test
  void returnsAfterItsTimeWhateverTheSpeedIs() throws PlanningException {
    assertEquals(50, rig.run(speed(TURNING, 0.5, 0.1)));
    assertEquals(-0.05, rig.control.speedRadPerS().q1(), 1e-12);
    assertEquals(1, rig.run(speed(TURNING, 0.5, 0)), "every call takes a frame");
  }

  @Test
  void theNextOneOfTheSameFrameTakesOverSmoothly() throws PlanningException {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
    rig.stream(100, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
    assertEquals(0.5, rig.largestAcceleration, 1e-6);
    assertEquals(Rig.READY.q1() - 0.16 - 0.08, rig.control.positionRad().q1(), 1e-9);
  }

  @Test
  void leftAloneItSlowsDownByItsOwnAcceleration() throws PlanningException {
    rig.run(rig.servoing.speedJ(TURNING, 2, UNTIL_REACHED));
    int frames = rig.untilRest();
    assertEquals(100, frames, 1, "0.4 rad/s by 2 rad/s²");
    assertEquals(2, rig.largestAcceleration, 1e-6);
    assertFalse(rig.control.moving());
  }

  @Test
  void aStopTakesItOver() throws PlanningException {
    rig.run(rig.servoing.speedJ(TURNING, 2, UNTIL_REACHED));
    MotionTicket ticket = rig.control.takeOver((q, qd) -> new StopJ(q, qd, 8));
    assertEquals(25, rig.wait(ticket));
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
  }

  @Test
  void speedsThatAJointCannotDoAreLoweredInProportion() throws PlanningException {
    rig.run(rig.servoing.speedJ(new Joints(10, 5, 0, 0, 0, 0), 20, UNTIL_REACHED));
    double most = rig.arm.joints().getFirst().maxSpeedRadPerS();
    assertEquals(most, rig.control.speedRadPerS().q0(), 1e-9);
    assertEquals(most / 2, rig.control.speedRadPerS().q1(), 1e-9);
  }

  @Test
  void theSliderSlowsDownTimeAndSpeed() throws PlanningException {
    rig.control.setSpeedFraction(0.25);
    assertEquals(4, rig.run(speed(TURNING, 0.5, 0.002)), "a call of a frame stretches over four");
    rig.stream(499, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(-0.1, rig.control.speedRadPerS().q1(), 1e-9);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.9999999999, 0.99, 0.9, 0.75, 2 / 3.0, 0.51, 0.5, 0.37, 0.03})
  void aStreamGoesTheSameWayAtEverySliderPosition(double slider) throws PlanningException {
    rig.control.setSpeedFraction(slider);
    int frames = 0;
    for (int i = 0; i < 500; i++) {
      frames += rig.run(speed(SPIN, 40, 0.002));
    }
    assertEquals(500 / slider, frames, 1, "1 s of the motion's own time");
    assertEquals(SPUN_RAD, spun(), SPUN_RAD * 0.003);
    assertEquals(slider * 0.2, rig.control.speedRadPerS().q5(), 1e-9);
    assertTrue(rig.largestAcceleration <= 40 + 1e-6, "by " + rig.largestAcceleration);
  }

  @Test
  void aStreamGoesTheSameWayWhileTheSliderMoves() throws PlanningException {
    Random random = new Random(2403);
    for (int run = 0; run < 40; run++) {
      Rig moved = new Rig();
      double start = moved.control.positionRad().q5();
      for (int i = 0; i < 500; i++) {
        if (random.nextInt(50) == 0) {
          moved.control.setSpeedFraction(0.05 + 0.95 * random.nextDouble());
        }
        moved.run(moved.servoing.speedJ(SPIN, 40, OptionalDouble.of(0.002)));
      }
      double spun = moved.control.positionRad().q5() - start;
      assertEquals(SPUN_RAD, spun, SPUN_RAD * 0.003, "run " + run + " of seed 2403");
      assertTrue(moved.largestAcceleration <= 48, "by " + moved.largestAcceleration);
    }
  }

  private double spun() {
    return rig.control.positionRad().q5() - Rig.READY.q5();
  }

  @Test
  void whatACallLastsLongerThanItsTimeIsTakenOffTheNextOne() throws PlanningException {
    int[] frames = new int[6];
    for (int i = 0; i < frames.length; i++) {
      frames[i] = rig.run(speed(TURNING, 0.5, 0.0048));
    }
    assertArrayEquals(new int[] {3, 2, 3, 2, 2, 3}, frames, "2.4 frames each");
  }

  @Test
  void callsOfLessThanAFrameLastOneAndOweNothing() throws PlanningException {
    rig.stream(10, i -> speed(TURNING, 0.5, 0));
    assertEquals(50, rig.run(speed(TURNING, 0.5, 0.1)));
    rig.stream(10, i -> speed(TURNING, 0.5, 0.0002));
    assertEquals(50, rig.run(speed(TURNING, 0.5, 0.1)), 1);
  }

  @Test
  void aPauseBetweenTwoCallsIsNotTakenOffTheNextOne() throws PlanningException {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    rig.control.halt(15);
    rig.steps(100);
    rig.control.resume();
    assertEquals(51, rig.run(speed(TURNING, 0.5, 0.1)), 1);
  }

  @Test
  void aStreamFollowsTheSliderWithoutJumps() throws PlanningException {
    rig.stream(400, i -> speed(TURNING, 2, 0.002));
    rig.control.setSpeedFraction(0.5);
    rig.stream(100, i -> speed(TURNING, 2, 0.002));
    assertEquals(-0.2, rig.control.speedRadPerS().q1(), 1e-9);
    rig.control.setSpeedFraction(1);
    rig.stream(200, i -> speed(TURNING, 2, 0.002));
    assertEquals(-0.4, rig.control.speedRadPerS().q1(), 1e-9);
    assertTrue(rig.largestAcceleration < 8.1);
  }

  @Test
  void aStreamThatComesTooLateKeepsToTheSlider() throws PlanningException {
    rig.control.setSpeedFraction(0.5);
    for (int i = 0; i < 1000; i++) {
      rig.run(speed(TURNING, 10, 0.008));
      rig.step();
    }
    assertTrue(Math.abs(rig.control.speedRadPerS().q1()) <= 0.2 + 1e-9);
    assertTrue(Math.abs(rig.control.speedRadPerS().q1()) > 0.15);
  }

  @Test
  void aLimitIsNoDebtThatHasToBePaidBack() throws PlanningException {
    PathLimiter slow = (q, qd) -> 0.2 / Joints.of(qd).maxAbsDifference(Joints.ZERO);
    MotionControl limited = new MotionControl(rig.arm, Rig.READY, slow);
    for (int i = 0; i < 1000; i++) {
      frames(limited, speed(Joints.ZERO.with(0, 3), 2, 0.002));
    }
    assertEquals(0.2, limited.speedRadPerS().q0(), 1e-3);
    int frames = 0;
    while (limited.speedRadPerS().q0() > 1e-9) {
      frames += frames(limited, speed(Joints.ZERO, 2, 0.002));
    }
    assertEquals(50, frames, 2, "0.2 rad/s by 2 rad/s²");
  }

  private static int frames(MotionControl control, MotionPlan plan) throws PlanningException {
    MotionTicket ticket = control.continueWith(plan);
    int frames = 0;
    while (!ticket.finished()) {
      control.step();
      frames++;
    }
    return frames;
  }

  @Test
  void aPauseHoldsItAndItGoesOnAfterwards() throws PlanningException {
    MotionTicket ticket =
        rig.control.continueWith(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
    rig.steps(100);
    rig.control.pause();
    rig.steps(100);
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
    assertFalse(ticket.finished());
    rig.control.resume();
    rig.wait(ticket);
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
  }

  @Test
  void aPauseBetweenTwoCallsHoldsItAsWell() throws PlanningException {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    rig.control.halt(15);
    int frames = 0;
    while (!rig.control.speedRadPerS().equals(Joints.ZERO)) {
      rig.step();
      frames++;
    }
    assertTrue(frames <= 15, "0.4 rad/s by 15 rad/s², not by 0.5: " + frames);
    rig.steps(100);
    rig.control.resume();
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
  }

  @Test
  void afterAPauseThatNobodyContinuesItEnds() throws PlanningException {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    rig.control.pause();
    rig.steps(200);
    rig.control.resume();
    rig.steps(2);
    assertFalse(rig.control.moving());
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
  }

  @Test
  void anEndedProgramBringsItToRestSooner() throws PlanningException {
    rig.run(rig.servoing.speedJ(TURNING, 0.05, OptionalDouble.of(4)));
    rig.control.abort();
    int frames = rig.untilRest();
    assertTrue(frames < 20, "as any motion, not by 0.05 rad/s²: " + frames);
  }

  @Test
  void aMotionFromRestIsRefusedMeanwhile() throws PlanningException {
    rig.run(speed(TURNING, 0.5, 0.2));
    PlanningException error =
        assertThrows(
            PlanningException.class, () -> rig.control.start((q, qd) -> new StopJ(q, qd, 1)));
    assertEquals("moving", error.code());
    assertTrue(error.getMessage().startsWith("speedj has left the arm moving"), error.getMessage());
  }

  @Test
  void aMotionFromRestIsFineWhereTheSpeedIsZero() throws PlanningException {
    rig.run(speed(Joints.ZERO, 0.5, 0.2));
    rig.control.start((q, qd) -> new StopJ(q, qd, 1));
    rig.steps(2);
    assertFalse(rig.control.moving());
  }

  @Test
  void anotherThreadCannotTakeItOverWhileSomebodyWaits() throws PlanningException {
    rig.control.continueWith(speed(TURNING, 0.5, 0.2));
    rig.step();
    PlanningException error =
        assertThrows(
            PlanningException.class, () -> rig.control.continueWith(speed(TURNING, 0.5, 0.2)));
    assertEquals("robot-in-use", error.code());
  }
}
