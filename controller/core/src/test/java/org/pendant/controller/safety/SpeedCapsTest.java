package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.message.MessageLog;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;

final class SpeedCapsTest {
  private static final Pose TOOL = new Pose(0.02, -0.01, 0.15, 0.1, 0, 0);

  /** Everything that is limited, worked out by another route, and the limit on it. */
  private record Measured(String what, double value, double limit) {}

  private static List<Measured> measure(
      ArmDescription arm, ArmDynamics dynamics, SafetyLimits limits, double[] q, double[] qd) {
    double[] jacobian = new double[Jacobian.SIZE];
    double[] twist = new double[6];
    new Jacobian(arm).at(q, TOOL, jacobian);
    Jacobian.twist(jacobian, qd, twist);
    double tool = Math.sqrt(twist[0] * twist[0] + twist[1] * twist[1] + twist[2] * twist[2]);
    double elbow = Math.abs(arm.dh().a2()) * Math.hypot(Math.cos(q[1]) * qd[0], qd[1]);
    double[] momentum = new double[3];
    dynamics.linearMomentum(q, qd, momentum);
    double fastest = 0;
    double jointShare = 0;
    for (int i = 0; i < 6; i++) {
      fastest = Math.max(fastest, Math.abs(qd[i]));
      jointShare = Math.max(jointShare, Math.abs(qd[i]) / arm.joints().get(i).maxSpeedRadPerS());
    }
    double stopS = fastest / 15;
    return List.of(
        // no joint may be asked for more than it can, which is less than the safety limit's share
        new Measured("joint speed", 0.97 * jointShare, 1),
        new Measured("tool speed", tool, limits.toolSpeedMPerS()),
        new Measured("elbow speed", elbow, limits.elbowSpeedMPerS()),
        new Measured("momentum", Observation.length(momentum), limits.momentumKgMPerS()),
        new Measured("stopping time", stopS, limits.stoppingTimeS()),
        new Measured("stopping distance", tool * stopS / 2, limits.stoppingDistanceM()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5", "ur5e", "ur10e", "ur16e", "ur15", "ur20", "ur30"})
  void largestScalingReachesOneLimitAndKeepsAll(String id) {
    ArmDescription arm = ArmLibrary.load(id);
    ArmDynamics dynamics = new ArmDynamics(arm);
    dynamics.setPayload(Payload.of(arm.payloadKg(), 0, 0, 0.05));
    SafetySystem safety =
        new SafetySystem(arm, SafetyConfiguration.standard(arm), new MessageLog(), true);
    SpeedCaps caps = new SpeedCaps(arm, dynamics, safety);
    caps.setTool(TOOL);
    Random random = new Random(11);
    for (int k = 0; k < 1000; k++) {
      double[] q = new double[6];
      double[] qd = new double[6];
      for (int i = 0; i < 6; i++) {
        q[i] = random.nextDouble(-6, 6);
        qd[i] = random.nextDouble(-4, 4);
      }
      double scaling = caps.largestScaling(q, qd);
      double[] scaled = new double[6];
      for (int i = 0; i < 6; i++) {
        scaled[i] = scaling * qd[i];
      }
      double fullest = 0;
      for (Measured each : measure(arm, dynamics, safety.limits(), q, scaled)) {
        double share = each.value / each.limit;
        assertTrue(share <= 0.97 + 1e-9, id + " " + k + ": " + each);
        fullest = Math.max(fullest, share);
      }
      assertEquals(0.97, fullest, 1e-9, id + " " + k);
    }
  }

  @Test
  void restIsNotLimited() {
    SafetyBench bench = SafetyBench.standard();
    SpeedCaps caps = new SpeedCaps(bench.arm, new ArmDynamics(bench.arm), bench.safety);
    assertEquals(
        Double.POSITIVE_INFINITY, caps.largestScaling(SafetyBench.START.toArray(), new double[6]));
  }

  static List<String> everyArm() {
    return ArmLibrary.ids();
  }

  @ParameterizedTest
  @MethodSource("everyArm")
  void eachJointAloneMayTurnAsFastAsItsDataSheetSaysWithTheArmFolded(String id) {
    ArmDescription arm = ArmLibrary.load(id);
    SafetySystem safety =
        new SafetySystem(arm, SafetyConfiguration.standard(arm), new MessageLog(), true);
    SpeedCaps caps = new SpeedCaps(arm, new ArmDynamics(arm), safety);
    double[] folded = {0, -Math.PI / 2, 2.6, 0, Math.PI / 2, 0};
    for (int i : new int[] {0, 3, 4, 5}) {
      Joints speed = SafetyBench.speed(i, arm.joints().get(i).maxSpeedRadPerS());
      double scaling = caps.largestScaling(folded, speed.toArray());
      assertTrue(scaling >= 1 - 1e-12, id + " joint " + i + ": " + scaling);
    }
  }

  /** The scaling that a joint speed above the reduced and below the normal limit gets. */
  private static double scalingOfAFastWrist(SafetyBench bench, Joints q) {
    SpeedCaps caps = new SpeedCaps(bench.arm, new ArmDynamics(bench.arm), bench.safety);
    return caps.largestScaling(q.toArray(), SafetyBench.speed(5, Math.PI).toArray());
  }

  @Test
  void reducedInputSlowsDownGraduallyAndInTime() {
    for (int hardness = 0; hardness <= 1; hardness++) {
      SafetyBench bench = SafetyBench.standard();
      bench.safety.setTransitionHardness(hardness);
      bench.step();
      double before = scalingOfAFastWrist(bench, SafetyBench.START);
      assertEquals(1, before, 1e-12);
      bench.safety.setInput(SafetyInput.REDUCED_MODE, true);
      for (int i = 0; i < 240; i++) {
        bench.step();
        double now = scalingOfAFastWrist(bench, SafetyBench.START);
        assertTrue(now <= before && now > before - 0.02, "frame " + i + ": " + now);
        before = now;
      }
      assertEquals(0.97 * 1.06 / 2, before, 1e-9);
    }
  }

  @Test
  void softTransitionTakesLonger() {
    SafetyBench bench = SafetyBench.standard();
    bench.safety.setTransitionHardness(1);
    bench.safety.setInput(SafetyInput.REDUCED_MODE, true);
    bench.steps(100);
    double soft = scalingOfAFastWrist(bench, SafetyBench.START);
    bench.safety.setTransitionHardness(0);
    assertTrue(soft > 1.2 * scalingOfAFastWrist(bench, SafetyBench.START));
  }

  @Test
  void armIsSlowBeforeItPassesATriggerPlane() {
    double height =
        new ForwardKinematics(SafetyBench.standard().arm).flangePose(SafetyBench.START).z();
    double before = Double.NEGATIVE_INFINITY;
    for (double aboveM = 0.019; aboveM < 0.3; aboveM += 0.01) {
      SafetyPlane plane =
          new SafetyPlane(
              "low", 0, 0, height - aboveM, new Axis(0, 0, 1), Applies.TRIGGERS_REDUCED, false);
      SafetyBench bench = SafetyBench.with(SafetyBench.standardOfUr5e().withPlanes(plane));
      double scaling = scalingOfAFastWrist(bench, SafetyBench.START);
      if (aboveM < 0.02) {
        assertEquals(0.97 * 1.06 / 2, scaling, 1e-9);
      }
      assertTrue(scaling >= before, "at " + aboveM + " m: " + scaling);
      before = scaling;
    }
    assertEquals(1, before, 1e-9);
  }

  @Test
  void recoveryIsSlow() {
    SafetyBench bench = SafetyBench.standard().at(SafetyBench.START.with(5, 2 * Math.PI + 0.2));
    bench.step();
    assertEquals(
        0.97 * Math.toRadians(30) / Math.PI, scalingOfAFastWrist(bench, SafetyBench.START), 1e-9);
  }
}
