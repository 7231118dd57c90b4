package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

@Tag("slow")
final class TorquePathLimitsTest {
  private static final Payload LOAD = new Payload(3, 0.02, 0, 0.08, 0.01, 0.01, 0.01, 0, 0, 0);

  private final MoveChain chain = new MoveChain();
  private final InverseKinematics inverse = new InverseKinematics(chain.arm);

  private Joints random(SplittableRandom random) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      q[i] = MoveChain.READY.get(i) + random.nextDouble(-1.2, 1.2);
    }
    return Joints.of(q);
  }

  private Motion plan(Move move, Joints from) throws PlanningException {
    return MovePlanner.fromRest(move, from, List.of());
  }

  /** The largest share of a speed limit, and of a torque limit, that a motion takes. */
  private double[] shares(Motion motion) {
    ArmDynamics dynamics = new ArmDynamics(chain.arm);
    dynamics.setPayload(LOAD);
    MotionSample sample = new MotionSample();
    double[] torque = new double[Joints.COUNT];
    double[] most = new double[2];
    for (double t = 0; t <= motion.durationS(); t += FrameTime.FRAME_S) {
      assertTrue(motion.sample(t, sample).isEmpty());
      dynamics.inverse(sample.position, sample.speed, sample.acceleration, torque);
      for (int i = 0; i < Joints.COUNT; i++) {
        JointLimits limit = chain.arm.joints().get(i);
        Actuator drive = chain.arm.actuators().get(i);
        double load = torque[i] + drive.rotorInertiaKgM2() * sample.acceleration[i];
        double friction = drive.slidingNm(Math.abs(sample.speed[i]), load);
        double needed = load + Math.signum(sample.speed[i]) * friction;
        most[0] = Math.max(most[0], Math.abs(sample.speed[i]) / limit.maxSpeedRadPerS());
        most[1] = Math.max(most[1], Math.abs(needed) / limit.maxTorqueNm());
      }
    }
    return most;
  }

  @Test
  void fullSharesOfAJointMoveReachALimitAndExceedNone() throws PlanningException {
    chain.headroom.setPayload(LOAD);
    SplittableRandom random = new SplittableRandom(5);
    int atFullSpeed = 0;
    for (int each = 0; each < 200; each++) {
      Joints from = random(random);
      Joints goal = random(random);
      double[] shares = shares(plan(chain.optimovej(goal, 1, 1, 0), from));
      String input = "move " + each + " from " + from + " to " + goal;
      assertTrue(shares[0] <= 1 + 1e-9, input + ": speed " + shares[0]);
      assertTrue(shares[1] <= 1, input + ": torque " + shares[1]);
      atFullSpeed += shares[0] > 0.99 ? 1 : 0;
    }
    assertTrue(atFullSpeed > 20, "only " + atFullSpeed + " at full speed");
  }

  @Test
  void aLongMoveOfAFreeArmGetsToTheSpeedLimitOfAJoint() throws PlanningException {
    SplittableRandom random = new SplittableRandom(7);
    for (int each = 0; each < 100; each++) {
      Joints goal = MoveChain.READY.with(0, random.nextDouble(2.5, 6)).with(5, random.nextDouble());
      double[] shares = shares(plan(chain.optimovej(goal, 1, 1, 0), MoveChain.READY));
      assertEquals(1, shares[0], 0.01, "goal " + goal);
    }
  }

  @Test
  void halfTheSpeedNeverTakesLess() throws PlanningException {
    SplittableRandom random = new SplittableRandom(6);
    for (int each = 0; each < 200; each++) {
      Joints from = random(random);
      Joints goal = random(random);
      double share = random.nextDouble(0.1, 1);
      double full = plan(chain.optimovej(goal, share, share, 0), from).durationS();
      double half = plan(chain.optimovej(goal, share, share / 2, 0), from).durationS();
      assertTrue(half >= full - 1e-9, "move " + each + ": " + half + " s after " + full);
    }
  }

  @Test
  void fullSharesOfALineStayWithinSpeedAndTorque() throws PlanningException {
    chain.headroom.setPayload(LOAD);
    SplittableRandom random = new SplittableRandom(8);
    for (int each = 0; each < 200; each++) {
      Pose goal =
          chain.shifted(
              random.nextDouble(-0.2, 0.2),
              random.nextDouble(-0.4, 0.4),
              random.nextDouble(-0.3, 0.2));
      if (inverse.solve(goal, MoveChain.TCP, MoveChain.READY).isEmpty()) {
        continue;
      }
      double[] shares = shares(plan(chain.optimovel(goal, 1, 1, 0), MoveChain.READY));
      assertTrue(shares[0] <= 1.03, "goal " + goal + ": speed " + shares[0]);
      assertTrue(shares[1] <= 1.03, "goal " + goal + ": torque " + shares[1]);
    }
  }

  @Test
  void aHeavierLoadTakesLonger() throws PlanningException {
    Joints goal = MoveChain.READY.with(1, -0.4);
    double free = plan(chain.optimovej(goal, 1, 1, 0), MoveChain.READY).durationS();
    chain.headroom.setPayload(Payload.of(5, 0, 0, 0.2));
    double loaded = plan(chain.optimovej(goal, 1, 1, 0), MoveChain.READY).durationS();
    assertTrue(loaded > free * 1.02, loaded + " s, " + free + " s without load");
  }

  @Test
  void aWrenchLimitKeepsWhatTheLoadDoesToTheToolBelowIt() throws PlanningException {
    Pose frame = new Pose(0, 0, 0.1, 0, 0, 0.7);
    chain.headroom.setPayload(LOAD);
    chain.headroom.setToolWrenchLimit(
        Optional.of(new ToolWrenchLimit(frame, List.of(4.0, 5.0, 6.0, 0.3, 0.4, 1.0))));
    List<Double> limits = chain.headroom.toolWrenchLimit().orElseThrow().limits();
    ArmDynamics dynamics = new ArmDynamics(chain.arm);
    dynamics.setGravity(0, 0, 0);
    SplittableRandom random = new SplittableRandom(9);
    double highest = 0;
    for (int each = 0; each < 200; each++) {
      Joints goal = random(random);
      Move move =
          each % 2 == 0
              ? chain.optimovej(goal, 1, 1, 0)
              : chain.movep(
                  chain.shifted(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.3, 0.3), -0.1),
                  5,
                  random.nextDouble(0.1, 1),
                  0);
      Motion motion = plan(move, MoveChain.READY);
      MotionSample sample = new MotionSample();
      double[] torque = new double[Joints.COUNT];
      double[] wrench = new double[Pose.SIZE];
      for (double t = 0; t <= motion.durationS(); t += FrameTime.FRAME_S) {
        assertTrue(motion.sample(t, sample).isEmpty());
        dynamics.inverse(sample.position, sample.speed, sample.acceleration, torque);
        dynamics.flangeMotion().loadOf(LOAD, wrench);
        chain.headroom.toolWrenchLimit().orElseThrow().carry(wrench);
        for (int i = 0; i < Pose.SIZE; i++) {
          double share = Math.abs(wrench[i]) / limits.get(i);
          assertTrue(share <= 1, "move " + each + ", axis " + i + ": " + share);
          highest = Math.max(highest, share);
        }
      }
    }
    assertTrue(highest > 0.8, "no more than " + highest + " of a limit is used");
  }

  @Test
  void theWrenchOfALoadIsCarriedToTheFrame() {
    double[] wrench = {0, 0, -10, 0, 0, 0};
    List<Double> any = List.of(1.0, 1.0, 1.0, 1.0, 1.0, 1.0);
    new ToolWrenchLimit(new Pose(0.1, 0, 0, 0, 0, 0), any).carry(wrench);
    // the force passes 0.1 m beside the frame
    assertEquals(-1, wrench[4], 1e-12);
    assertEquals(-10, wrench[2], 1e-12);
  }
}
