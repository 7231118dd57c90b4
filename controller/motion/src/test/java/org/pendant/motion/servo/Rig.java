package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.IntFunction;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;

/** A UR5e whose target is steered frame by frame; every frame is checked against its joints. */
final class Rig {
  static final double FRAME_S = FrameTime.FRAME_S;
  static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  static final Pose TCP = new Pose(0.01, -0.02, 0.12, 0.1, -0.3, 0.2);

  final ArmDescription arm = ArmLibrary.load("ur5e");
  final MotionControl control;
  final Servoing servoing;
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final Jacobian jacobian = new Jacobian(arm);
  private Joints before;
  private Joints speedBefore = Joints.ZERO;
  double largestAcceleration;

  Rig() {
    this(READY);
  }

  Rig(Joints start) {
    control = new MotionControl(arm, start);
    servoing = new Servoing(arm, control);
    before = start;
  }

  /** One frame; fails if a joint turns too fast, or its position does not follow from its speed. */
  void step() {
    control.step();
    Joints q = control.positionRad();
    Joints qd = control.speedRadPerS();
    assertTrue(q.isFinite() && qd.isFinite() && control.accelerationRadPerS2().isFinite());
    double change = qd.maxAbsDifference(speedBefore);
    largestAcceleration = Math.max(largestAcceleration, change / FRAME_S);
    for (int i = 0; i < Joints.COUNT; i++) {
      double most = arm.joints().get(i).maxSpeedRadPerS() * (1 + 1e-9);
      double moved = q.get(i) - before.get(i);
      assertTrue(Math.abs(qd.get(i)) <= most, () -> "too fast: " + qd);
      assertTrue(Math.abs(moved) <= most * FRAME_S, () -> "moved too far: " + q);
      double mean = 0.5 * (qd.get(i) + speedBefore.get(i)) * FRAME_S;
      assertTrue(Math.abs(moved - mean) <= change * FRAME_S + 1e-12, () -> "jumped: " + q);
    }
    before = q;
    speedBefore = qd;
  }

  void steps(int count) {
    for (int i = 0; i < count; i++) {
      step();
    }
  }

  /** Starts a motion and steps until it hands over or ends; returns the frames that took. */
  int run(MotionPlan plan) throws PlanningException {
    MotionTicket ticket = control.continueWith(plan);
    return wait(ticket);
  }

  int wait(MotionTicket ticket) {
    int frames = 0;
    while (!ticket.finished()) {
      step();
      frames++;
      assertTrue(ticket.failure().isEmpty(), () -> ticket.failure().toString());
      assertTrue(frames < 100_000);
    }
    return frames;
  }

  /** As a program does that asks for the next motion as soon as the one before hands over. */
  void stream(int count, IntFunction<MotionPlan> plans) throws PlanningException {
    for (int i = 0; i < count; i++) {
      run(plans.apply(i));
    }
  }

  int untilRest() {
    int frames = 0;
    while (!control.speedRadPerS().equals(Joints.ZERO) || control.moving()) {
      step();
      frames++;
      assertTrue(frames < 100_000);
    }
    return frames;
  }

  Pose tcp() {
    return forward.tcpPose(control.positionRad(), TCP);
  }

  /** Velocity of the TCP, m/s and rad/s. */
  double[] twist() {
    double[] matrix = new double[Jacobian.SIZE];
    double[] twist = new double[Joints.COUNT];
    jacobian.at(control.positionRad().toArray(), TCP, matrix);
    Jacobian.twist(matrix, control.speedRadPerS().toArray(), twist);
    return twist;
  }
}
