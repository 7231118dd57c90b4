package org.pendant.controller.motion.servo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.motion.MotionControl;
import org.pendant.controller.motion.MotionPlan;
import org.pendant.controller.motion.MotionTicket;
import org.pendant.controller.motion.PathLimiter;
import org.pendant.controller.motion.StopJ;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;

class SpeedJTest {
  private static final Joints TURNING = new Joints(0.2, -0.4, 0.1, 0.05, 0, 0.3);
  private static final OptionalDouble UNTIL_REACHED = OptionalDouble.empty();

  private final Rig rig = new Rig();

  private MotionPlan speed(Joints wanted, double acceleration, double returnS) {
    return rig.servoing.speedJ(wanted, acceleration, OptionalDouble.of(returnS));
  }

  @Test
  void returnsWhenTheSpeedIsReached() throws ScriptError {
    int frames = rig.run(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
    assertEquals(400, frames, "0.4 rad/s by 0.5 rad/s² take 0.8 s");
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-12);
    assertEquals(0.5, rig.largestAcceleration, 1e-9);
    assertEquals(Rig.READY.q1() - 0.16, rig.control.positionRad().q1(), 1e-12);
  }

  @Test
  void allJointsArriveAtTheSameMoment() throws ScriptError {
    rig.control.goOn(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
    rig.steps(200);
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(TURNING.get(i) / 2, rig.control.speedRadPerS().get(i), 1e-12);
    }
  }

  @Test
  void returnsAfterItsTimeWhateverTheSpeedIs() throws ScriptError {
    assertEquals(50, rig.run(speed(TURNING, 0.5, 0.1)));
    assertEquals(-0.05, rig.control.speedRadPerS().q1(), 1e-12);
    assertEquals(1, rig.run(speed(TURNING, 0.5, 0)), "every call takes a frame");
  }

  @Test
  void theNextOneOfTheSameFrameTakesOverSmoothly() throws ScriptError {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
    rig.stream(100, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(0, rig.control.speedRadPerS().maxAbsDifference(TURNING), 1e-9);
    assertEquals(0.5, rig.largestAcceleration, 1e-6);
    assertEquals(Rig.READY.q1() - 0.16 - 0.08, rig.control.positionRad().q1(), 1e-9);
  }

  @Test
  void leftAloneItSlowsDownByItsOwnAcceleration() throws ScriptError {
    rig.run(rig.servoing.speedJ(TURNING, 2, UNTIL_REACHED));
    int frames = rig.untilRest();
    assertEquals(100, frames, 1, "0.4 rad/s by 2 rad/s²");
    assertEquals(2, rig.largestAcceleration, 1e-6);
    assertFalse(rig.control.moving());
  }

  @Test
  void aStopTakesItOver() throws ScriptError {
    rig.run(rig.servoing.speedJ(TURNING, 2, UNTIL_REACHED));
    MotionTicket ticket = rig.control.takeOver((q, qd) -> new StopJ(q, qd, 8));
    assertEquals(25, rig.wait(ticket));
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
  }

  @Test
  void speedsThatAJointCannotDoAreLoweredInProportion() throws ScriptError {
    rig.run(rig.servoing.speedJ(new Joints(10, 5, 0, 0, 0, 0), 20, UNTIL_REACHED));
    double most = rig.arm.joints().getFirst().maxSpeedRadPerS();
    assertEquals(most, rig.control.speedRadPerS().q0(), 1e-9);
    assertEquals(most / 2, rig.control.speedRadPerS().q1(), 1e-9);
  }

  @Test
  void theSliderSlowsDownTimeAndSpeed() throws ScriptError {
    rig.control.setSpeedFraction(0.25);
    assertEquals(4, rig.run(speed(TURNING, 0.5, 0.002)), "a call of a frame stretches over four");
    rig.stream(499, i -> speed(TURNING, 0.5, 0.002));
    assertEquals(-0.1, rig.control.speedRadPerS().q1(), 1e-9);
  }

  @Test
  void aStreamFollowsTheSliderWithoutJumps() throws ScriptError {
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
  void aStreamThatComesTooLateKeepsToTheSlider() throws ScriptError {
    rig.control.setSpeedFraction(0.5);
    for (int i = 0; i < 1000; i++) {
      rig.run(speed(TURNING, 10, 0.008));
      rig.step();
    }
    assertTrue(Math.abs(rig.control.speedRadPerS().q1()) <= 0.2 + 1e-9);
    assertTrue(Math.abs(rig.control.speedRadPerS().q1()) > 0.15);
  }

  @Test
  void aLimitIsNoDebtThatHasToBePaidBack() throws ScriptError {
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

  private static int frames(MotionControl control, MotionPlan plan) throws ScriptError {
    MotionTicket ticket = control.goOn(plan);
    int frames = 0;
    while (!ticket.finished()) {
      control.step();
      frames++;
    }
    return frames;
  }

  @Test
  void aPauseHoldsItAndItGoesOnAfterwards() throws ScriptError {
    MotionTicket ticket = rig.control.goOn(rig.servoing.speedJ(TURNING, 0.5, UNTIL_REACHED));
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
  void aPauseBetweenTwoCallsHoldsItAsWell() throws ScriptError {
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
  void afterAPauseThatNobodyContinuesItEnds() throws ScriptError {
    rig.stream(400, i -> speed(TURNING, 0.5, 0.002));
    rig.control.pause();
    rig.steps(200);
    rig.control.resume();
    rig.steps(2);
    assertFalse(rig.control.moving());
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
  }

  @Test
  void anEndedProgramBringsItToRestSooner() throws ScriptError {
    rig.run(rig.servoing.speedJ(TURNING, 0.05, OptionalDouble.of(4)));
    rig.control.abort();
    int frames = rig.untilRest();
    assertTrue(frames < 20, "as any motion, not by 0.05 rad/s²: " + frames);
  }

  @Test
  void aMotionFromRestIsRefusedMeanwhile() throws ScriptError {
    rig.run(speed(TURNING, 0.5, 0.2));
    ScriptError error =
        assertThrows(ScriptError.class, () -> rig.control.start((q, qd) -> new StopJ(q, qd, 1)));
    assertEquals("moving", error.code());
    assertTrue(error.getMessage().startsWith("speedj has left the arm moving"), error.getMessage());
  }

  @Test
  void aMotionFromRestIsFineWhereTheSpeedIsZero() throws ScriptError {
    rig.run(speed(Joints.ZERO, 0.5, 0.2));
    rig.control.start((q, qd) -> new StopJ(q, qd, 1));
    rig.steps(2);
    assertFalse(rig.control.moving());
  }

  @Test
  void anotherThreadCannotTakeItOverWhileSomebodyWaits() throws ScriptError {
    rig.control.goOn(speed(TURNING, 0.5, 0.2));
    rig.step();
    ScriptError error =
        assertThrows(ScriptError.class, () -> rig.control.goOn(speed(TURNING, 0.5, 0.2)));
    assertEquals("robot-in-use", error.code());
  }
}
