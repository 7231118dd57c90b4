package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;

class SpeedLTest {
  private static final OptionalDouble UNTIL_REACHED = OptionalDouble.empty();

  private final Rig rig = new Rig();

  private MotionPlan speed(double acceleration, double turning, double returnS, double... twist) {
    return rig.servoing.speedL(Rig.TCP, twist, acceleration, turning, OptionalDouble.of(returnS));
  }

  private static double length(double[] v, int first) {
    return Math.hypot(Math.hypot(v[first], v[first + 1]), v[first + 2]);
  }

  @Test
  void theToolSpeedsUpEvenlyAlongAStraightLine() throws PlanningException {
    Pose start = rig.tcp();
    double[] wanted = {0.06, 0, -0.08, 0, 0, 0};
    int frames = rig.run(rig.servoing.speedL(Rig.TCP, wanted, 0.5, 0.5, UNTIL_REACHED));
    assertEquals(100, frames, "0.1 m/s by 0.5 m/s²");
    double[] twist = rig.twist();
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(wanted[i], twist[i], 1e-9);
    }
    rig.stream(1, i -> speed(0.5, 0.5, 0.3, wanted));
    Pose end = rig.tcp();
    double way = 0.01 + 0.03;
    assertEquals(start.x() + 0.6 * way, end.x(), 1e-9);
    assertEquals(start.y(), end.y(), 1e-9);
    assertEquals(start.z() - 0.8 * way, end.z(), 1e-9);
    assertEquals(0, Poses.rotationAngle(start, end), 1e-9);
  }

  @Test
  void rotationIsAnAngularVelocityInTheBase() throws PlanningException {
    Pose start = rig.tcp();
    rig.run(speed(1, 1, 0.5, 0, 0, 0, 0, 0, 0.4));
    rig.run(speed(1, 1, 0.5, 0, 0, 0, 0, 0, 0.4));
    double angle = 0.08 + 0.4 * 0.6;
    Pose turned = Poses.add(new Pose(0, 0, 0, 0, 0, angle), start);
    assertEquals(0, Poses.rotationAngle(turned, rig.tcp()), 1e-9);
    assertEquals(0, Poses.pointDistance(start, rig.tcp()), 1e-9);
  }

  @Test
  void positionAndRotationArriveTogether() throws PlanningException {
    double[] wanted = {0.1, 0, 0, 0, 0, 0.3};
    int frames = rig.run(rig.servoing.speedL(Rig.TCP, wanted, 1, 0.5, UNTIL_REACHED));
    assertEquals(300, frames, "the turn takes longer: 0.3 rad/s by 0.5 rad/s²");
    Rig second = new Rig();
    second.control.continueWith(second.servoing.speedL(Rig.TCP, wanted, 1, 0.5, UNTIL_REACHED));
    second.steps(150);
    assertEquals(0.05, second.twist()[0], 1e-9);
    assertEquals(0.15, second.twist()[5], 1e-9);
  }

  @Test
  void theAxisOfTurningMayChangeOnTheWay() throws PlanningException {
    rig.run(speed(1, 1, 0.5, 0.02, 0, 0, 0.4, 0, 0));
    double[] wanted = {0, 0.02, 0, 0, 0.4, 0};
    int frames = rig.run(rig.servoing.speedL(Rig.TCP, wanted, 1, 1, UNTIL_REACHED));
    assertEquals(Math.ceil(0.4 * Math.sqrt(2) / 0.002), frames, 1);
    double[] twist = rig.twist();
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(wanted[i], twist[i], 1e-9);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.99, 0.9, 0.75, 0.5, 0.37, 0.03})
  void aStreamGoesTheSameWayAtEverySliderPosition(double slider) throws PlanningException {
    Pose start = rig.tcp();
    rig.control.setSpeedFraction(slider);
    double[] wanted = {0.06, 0, -0.08, 0, 0, 0.2};
    int frames = 0;
    for (int i = 0; i < 500; i++) {
      frames += rig.run(speed(20, 40, 0.002, wanted));
    }
    assertEquals(500 / slider, frames, 1);
    // 1 s, less half of the 5 ms in which the tool speeds up
    assertEquals(0.1 * 0.9975, Poses.pointDistance(start, rig.tcp()), 0.1 * 0.003);
    assertEquals(0.2 * 0.9975, Poses.rotationAngle(start, rig.tcp()), 0.2 * 0.003);
  }

  @Test
  void aStreamIsTheSameMotion() throws PlanningException {
    Rig whole = new Rig();
    double[] wanted = {0.05, -0.03, 0.02, 0.1, 0.2, -0.1};
    whole.run(whole.servoing.speedL(Rig.TCP, wanted, 0.2, 0.4, OptionalDouble.of(1)));
    rig.stream(500, i -> speed(0.2, 0.4, 0.002, wanted));
    assertEquals(0, Poses.pointDistance(whole.tcp(), rig.tcp()), 1e-7);
    assertEquals(0, whole.control.positionRad().maxAbsDifference(rig.control.positionRad()), 1e-6);
  }

  @Test
  void leftAloneItSlowsDownAlongItsDirection() throws PlanningException {
    Pose start = rig.tcp();
    rig.run(
        rig.servoing.speedL(Rig.TCP, new double[] {0, 0.1, 0, 0, 0, 0}, 0.5, 0.5, UNTIL_REACHED));
    rig.untilRest();
    assertEquals(start.x(), rig.tcp().x(), 1e-9);
    assertEquals(start.y() + 0.01 + 0.01, rig.tcp().y(), 1e-6 + 2e-4);
  }

  @Test
  void nearASingularityItSlowsDownStopsAndSaysWhy() throws PlanningException {
    double most = 0.9 * rig.arm.joints().get(2).maxSpeedRadPerS();
    MotionControl slow =
        new MotionControl(
            rig.arm, Rig.READY, (q, qd) -> most / Joints.of(qd).maxAbsDifference(Joints.ZERO));
    // straight out until the elbow is stretched
    MotionTicket ticket = slow.continueWith(speed(1, 1, 10, -0.25, 0, 0, 0, 0, 0));
    Joints before = Rig.READY;
    double lowest = 1;
    while (ticket.failure().isEmpty()) {
      slow.step();
      lowest = Math.min(lowest, slow.scaling());
      double moved = slow.positionRad().maxAbsDifference(before);
      assertTrue(moved <= most * Rig.FRAME_S * 1.01, () -> "too fast: " + slow.speedRadPerS());
      before = slow.positionRad();
      assertFalse(ticket.finished());
    }
    assertTrue(lowest < 0.9, "slowed down before: " + lowest);
    MotionFailure failure = ticket.failure().orElseThrow();
    assertTrue(
        failure.code().equals("singularity") || failure.code().equals("no-solution"),
        failure.message());
    while (slow.moving()) {
      slow.step();
    }
    assertEquals(Joints.ZERO, slow.speedRadPerS());
  }

  @Test
  void atHalfSpeedItGoesHalfAsFarOnTheSameLine() throws PlanningException {
    double[] wanted = {0, 0.1, 0, 0, 0, 0};
    rig.control.setSpeedFraction(0.5);
    Pose start = rig.tcp();
    rig.control.continueWith(rig.servoing.speedL(Rig.TCP, wanted, 0.5, 0.5, OptionalDouble.of(5)));
    rig.steps(1000);
    assertEquals(start.y() + 0.01 + 0.1 * 0.8, rig.tcp().y(), 1e-9);
    assertEquals(0.05, length(rig.twist(), 0), 1e-9);
  }
}
