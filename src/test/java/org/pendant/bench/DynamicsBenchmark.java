package org.pendant.bench;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.ejml.data.DMatrixRMaj;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;

/** Dynamics of a UR5e with a payload, at changing states; nothing is allocated. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class DynamicsBenchmark {
  private static final int STATES = 64;

  private final ArmDynamics dynamics = new ArmDynamics(ArmLibrary.load("ur5e"));
  private final double[][] q = states(3);
  private final double[][] qd = states(2);
  private final double[][] qdd = states(5);
  private final double[] result = new double[6];
  private final DMatrixRMaj mass = new DMatrixRMaj(6, 6);
  private int state;

  /** Hangs a payload on the flange. */
  public DynamicsBenchmark() {
    dynamics.setPayload(new Payload(3, 0.02, 0, 0.1, 0.01, 0.01, 0.01, 0, 0, 0));
  }

  private static double[][] states(double size) {
    SplittableRandom random = new SplittableRandom(3);
    double[][] states = new double[STATES][6];
    for (double[] each : states) {
      for (int i = 0; i < each.length; i++) {
        each[i] = size * (2 * random.nextDouble() - 1);
      }
    }
    return states;
  }

  private int next() {
    state = (state + 1) % STATES;
    return state;
  }

  /** Torques that a motion needs. */
  @Benchmark
  public double[] inverse() {
    int i = next();
    dynamics.inverse(q[i], qd[i], qdd[i], result);
    return result;
  }

  /** The mass matrix. */
  @Benchmark
  public DMatrixRMaj mass() {
    dynamics.mass(q[next()], true, mass);
    return mass;
  }

  /** Accelerations that torques give. */
  @Benchmark
  public double[] forward() {
    int i = next();
    dynamics.forward(q[i], qd[i], qdd[i], true, result);
    return result;
  }
}
