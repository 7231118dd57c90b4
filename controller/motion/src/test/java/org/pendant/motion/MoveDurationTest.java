package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

/** Moves from rest to rest take the time of their closed forms, and lines are straight. */
@Tag("slow")
final class MoveDurationTest {
  private static final int CASES = 30;
  private static final double JERK_RAMP_S = 0.08;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0.01, -0.02, 0.12, 0.1, -0.3, 0.2);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final SplittableRandom random = new SplittableRandom(11);

  /** Even acceleration: up, even speed, down. */
  private static double trapezoidS(double d, double v, double a) {
    return d * a >= v * v ? d / v + v / a : 2 * Math.sqrt(d / a);
  }

  /** With limited jerk; a ramp to a speed covers half of that speed times its duration. */
  private static double sevenPhasesS(double d, double v, double a, double j) {
    double peak = v;
    if (d < v * rampS(v, a, j)) {
      double triangle = Math.cbrt(d * d * j / 4);
      double b = a * a / j;
      peak = triangle * j <= a * a ? triangle : (Math.sqrt(b * b + 4 * a * d) - b) / 2;
    }
    double ramp = rampS(peak, a, j);
    return 2 * ramp + Math.max(0, d / peak - ramp);
  }

  private static double rampS(double v, double a, double j) {
    return v * j >= a * a ? v / a + a / j : 2 * Math.sqrt(v / j);
  }

  private Joints near(Joints middle, double spread) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < q.length; i++) {
      q[i] = middle.get(i) + random.nextDouble(-spread, spread);
    }
    return Joints.of(q);
  }

  @ParameterizedTest
  @CsvSource({"false, 1", "false, 2", "true, 1", "true, 2"})
  void durationsAreThoseOfTheClosedFormsWithinAFrame(boolean linear, int version)
      throws PlanningException {
    for (int each = 0; each < CASES; each++) {
      double part = linear ? 0.3 : 1.5;
      Joints start = near(READY, part);
      Joints goal = near(start, part);
      Pose from = forward.tcpPose(start, TCP);
      Pose to = forward.tcpPose(goal, TCP);
      double a = linear ? random.nextDouble(0.1, 1) : random.nextDouble(0.2, 8);
      double v = linear ? random.nextDouble(0.02, 0.2) : random.nextDouble(0.05, 3);
      Move.PathPlanner route =
          linear
              ? q -> Routes.line(arm, q, from, to, TCP)
              : q -> Routes.joints(arm, q, goal, to, TCP);
      double ramp = version == 2 ? JERK_RAMP_S : 0;
      MotionControl control = new MotionControl(arm, start);
      MotionTicket ticket =
          control.start(new Move(route, new MoveLimits(a, v, 0), 0, ramp)).orElseThrow();
      int frames = 0;
      double aside = 0;
      while (!ticket.finished()) {
        control.step();
        frames++;
        assertEquals(Optional.empty(), ticket.failure());
        aside = Math.max(aside, linear ? aside(from, to, control.positionRad()) : 0);
      }
      double turned = Poses.rotationAngle(from, to) / MoveL.ROTATION_FACTOR;
      double d =
          linear ? Math.max(Poses.pointDistance(from, to), turned) : goal.maxAbsDifference(start);
      double expectedS =
          version == 1 ? trapezoidS(d, v, a) : sevenPhasesS(d, v, a, a / JERK_RAMP_S);
      String input = start + " to " + goal + ", a " + a + ", v " + v;
      assertEquals(expectedS / FrameTime.FRAME_S, frames, 1, input);
      assertTrue(aside < 1e-9, input + ": " + aside + " m beside the line");
    }
  }

  private double aside(Pose from, Pose to, Joints q) {
    double length = Poses.pointDistance(from, to);
    Pose now = forward.tcpPose(q, TCP);
    double part = Poses.pointDistance(from, now) / length;
    return Poses.pointDistance(Poses.interpolate(from, to, part), now);
  }
}
