package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.PlanningException;

@Tag("slow")
class ServoJTest {
  private final Rig rig = new Rig();

  private MotionPlan to(Joints goal, double timeS, double lookaheadS, double gain) {
    return rig.servoing.servoJ(goal, timeS, lookaheadS, gain);
  }

  @Test
  void lagsARampByTheLookaheadTime() throws PlanningException {
    for (double lookaheadS : new double[] {0.03, 0.1, 0.2}) {
      for (double gain : new double[] {100, 300, 2000}) {
        Rig one = new Rig();
        double rate = 0.5;
        for (int i = 0; i < 5500; i++) {
          Joints goal = Rig.READY.with(0, rate * i * Rig.FRAME_S);
          if (i > 5000) {
            double behind = goal.q0() - one.control.positionRad().q0();
            assertEquals(lookaheadS, behind / rate, 1e-4, lookaheadS + " s, " + gain);
          }
          one.run(one.servoing.servoJ(goal, Rig.FRAME_S, lookaheadS, gain));
        }
      }
    }
  }

  @Test
  void comesToAGoalThatStays() throws PlanningException {
    Joints goal = Rig.READY.with(2, -1.5).with(5, 0.1);
    rig.stream(1000, i -> to(goal, 0.002, 0.1, 300));
    assertEquals(0, rig.control.positionRad().maxAbsDifference(goal), 1e-6);
  }

  @Test
  void followsACircleAtEveryFrame() throws PlanningException {
    double turn = 2 * Math.PI * 0.5;
    double worst = 0;
    for (int i = 0; i < 3000; i++) {
      double t = i * Rig.FRAME_S;
      Joints goal =
          Rig.READY.with(0, 0.2 * Math.sin(turn * t)).with(1, -1.77 + 0.2 * Math.cos(turn * t));
      if (i > 1000) {
        // the law is linear: gain / (gain - w^2 + i w gain lookahead) on a sine
        double w = turn;
        double re = 300 - w * w;
        double im = 300 * w * 0.1;
        double size = 300 / Math.hypot(re, im);
        double late = Math.atan2(im, re);
        double expected = 0.2 * size * Math.sin(turn * t - late);
        worst = Math.max(worst, Math.abs(expected - rig.control.positionRad().q0()));
      }
      rig.run(to(goal, 0.002, 0.1, 300));
    }
    assertTrue(worst < 1e-3, () -> "away by " + rig.control.positionRad());
  }

  @Test
  void holdsTheThreadForItsTime() throws PlanningException {
    assertEquals(4, rig.run(to(Rig.READY, 0.008, 0.1, 300)));
    assertEquals(1, rig.run(to(Rig.READY, 0.002, 0.1, 300)));
    assertEquals(1, rig.run(to(Rig.READY, 0, 0.1, 300)));
  }

  @Test
  void callsOfAFrameTakeAsMuchLongerAsTheSliderIsLower() throws PlanningException {
    rig.control.setSpeedFraction(0.99);
    int frames = 0;
    for (int i = 0; i < 500; i++) {
      frames += rig.run(to(Rig.READY.with(0, 0.001 * i), 0.002, 0.1, 300));
    }
    assertEquals(500 / 0.99, frames, 1);
  }

  @Test
  void atHalfSpeedACallOfAFrameTakesTwoAndTheProgressIsHalved() throws PlanningException {
    Rig half = new Rig();
    half.control.setSpeedFraction(0.5);
    for (int i = 0; i < 200; i++) {
      Joints goal = Rig.READY.with(0, 0.3 * i * Rig.FRAME_S);
      assertEquals(1, rig.run(rig.servoing.servoJ(goal, 0.002, 0.1, 300)));
      assertEquals(2, half.run(half.servoing.servoJ(goal, 0.002, 0.1, 300)));
      assertEquals(rig.control.positionRad().q0(), half.control.positionRad().q0(), 1e-12);
      assertEquals(rig.control.speedRadPerS().q0() / 2, half.control.speedRadPerS().q0(), 1e-12);
    }
  }

  @Test
  void aJumpOfTheGoalKeepsToWhatTheJointsCanDo() throws PlanningException {
    Joints far = Rig.READY.with(0, 2).with(4, -2);
    rig.stream(1500, i -> to(far, 0.002, 0.03, 2000));
    assertTrue(rig.largestAcceleration <= ServoJ.MAX_RAD_PER_S2 * (1 + 1e-9));
    assertEquals(0, rig.control.positionRad().maxAbsDifference(far), 1e-3);
  }

  @Test
  void leftAloneItComesToRest() throws PlanningException {
    rig.stream(200, i -> to(Rig.READY.with(0, 0.5 * i * Rig.FRAME_S), 0.002, 0.1, 300));
    double speed = rig.control.speedRadPerS().q0();
    int frames = rig.untilRest();
    assertEquals(speed / 8 / Rig.FRAME_S, frames, 2);
    assertFalse(rig.control.moving());
  }

  @Test
  void aMoveIsRefusedWhileItMoves() throws PlanningException {
    rig.stream(200, i -> to(Rig.READY.with(0, 0.5 * i * Rig.FRAME_S), 0.002, 0.1, 300));
    PlanningException error =
        assertThrows(PlanningException.class, () -> rig.control.start((q, qd) -> null));
    assertTrue(error.getMessage().startsWith("servoj has left"), error.getMessage());
  }

  @Test
  void aPausedStreamGoesOnFromWhereItRests() throws PlanningException {
    Joints goal = Rig.READY.with(0, 0.5);
    rig.stream(40, i -> to(goal, 0.002, 0.1, 300));
    rig.control.pause();
    rig.steps(300);
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
    rig.control.resume();
    rig.stream(1500, i -> to(goal, 0.002, 0.1, 300));
    assertEquals(0, rig.control.positionRad().maxAbsDifference(goal), 1e-6);
    assertTrue(rig.largestAcceleration <= ServoJ.MAX_RAD_PER_S2 * (1 + 1e-9));
  }

  @Test
  void randomStreamsStayWithinLimits() throws PlanningException {
    SplittableRandom random = new SplittableRandom(7);
    for (int each = 0; each < 60; each++) {
      Rig one = new Rig();
      double lookaheadS = 0.03 + 0.17 * random.nextDouble();
      double gain = 100 + 1900 * random.nextDouble();
      String input = "stream " + each + ": lookahead " + lookaheadS + ", gain " + gain;
      for (int i = 0; i < 300; i++) {
        double[] goal = new double[Joints.COUNT];
        for (int k = 0; k < goal.length; k++) {
          goal[k] = 6.2 * (2 * random.nextDouble() - 1);
        }
        if (random.nextInt(50) == 0) {
          one.control.setSpeedFraction(0.05 + 0.95 * random.nextDouble());
        }
        double timeS = random.nextInt(4) == 0 ? 0.05 * random.nextDouble() : 0.002;
        one.run(one.servoing.servoJ(Joints.of(goal), timeS, lookaheadS, gain));
        if (random.nextInt(20) == 0) {
          one.steps(random.nextInt(5));
        }
      }
      // the servo's own and that of the slider
      double most = ServoJ.MAX_RAD_PER_S2 + MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
      assertTrue(one.largestAcceleration <= most * (1 + 1e-6), input);
      one.untilRest();
    }
  }
}
