package org.pendant.bench;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Kinematics of the UR5e, one call at a time, at joint positions spread over the whole range: every
 * pose has solutions, most of them eight.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class KinematicsBenchmark {
  /** A power of two: the next state is found by a mask. */
  private static final int STATES = 1024;

  private static final Pose TCP_IN_FLANGE = new Pose(0.01, -0.02, 0.15, 0.1, 0.2, 0.3);

  private final double[][] q = new double[STATES][Joints.COUNT];
  private final double[][] qd = new double[STATES][Joints.COUNT];
  private final double[][] flanges = new double[STATES][Transforms.SIZE];
  private final double[] transform = new double[Transforms.SIZE];
  private final double[] matrix = new double[Jacobian.SIZE];
  private final double[][] solutions = new double[InverseKinematics.MAX_SOLUTIONS][Joints.COUNT];
  private final double[] tracked = new double[Joints.COUNT];

  private ForwardKinematics forward;
  private InverseKinematics inverse;
  private Jacobian jacobian;
  private int next;

  /** Draws the states. */
  @Setup
  public void draw() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    forward = new ForwardKinematics(arm);
    inverse = new InverseKinematics(arm);
    jacobian = new Jacobian(arm);
    Random random = new Random(1);
    for (int state = 0; state < STATES; state++) {
      for (int i = 0; i < Joints.COUNT; i++) {
        q[state][i] = 2 * Math.PI * (2 * random.nextDouble() - 1);
        qd[state][i] = 2 * random.nextDouble() - 1;
      }
      forward.flange(q[state], flanges[state]);
    }
  }

  /** Joints to the transformation of the flange. */
  @Benchmark
  public double[] flange() {
    forward.flange(q[step()], transform);
    return transform;
  }

  /** Joints to the Jacobian at a TCP. */
  @Benchmark
  public double[] jacobian() {
    jacobian.at(q[step()], TCP_IN_FLANGE, matrix);
    return matrix;
  }

  /** Joints and speeds to the Jacobian's time derivative. */
  @Benchmark
  public double[] jacobianDerivative() {
    int state = step();
    jacobian.derivative(q[state], qd[state], TCP_IN_FLANGE, matrix);
    return matrix;
  }

  /** Flange to all solutions, checked and sorted. */
  @Benchmark
  public int allSolutions() {
    int state = step();
    int count = inverse.allInto(flanges[state], q[state], solutions);
    if (count == 0) {
      throw new IllegalStateException("no solution at " + Joints.of(q[state]));
    }
    return count;
  }

  /** Flange to the solution next to known joints, as a linear move asks for it every frame. */
  @Benchmark
  public boolean track() {
    int state = step();
    System.arraycopy(q[state], 0, tracked, 0, Joints.COUNT);
    return inverse.track(flanges[state], tracked);
  }

  private int step() {
    next = (next + 1) & (STATES - 1);
    return next;
  }
}
