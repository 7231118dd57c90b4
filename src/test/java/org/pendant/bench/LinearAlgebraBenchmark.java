package org.pendant.bench;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.ejml.data.DMatrix4x4;
import org.ejml.data.DMatrix6;
import org.ejml.data.DMatrix6x6;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.fixed.CommonOps_DDF4;
import org.ejml.dense.fixed.CommonOps_DDF6;
import org.ejml.dense.row.decomposition.lu.LUDecompositionAlt_DDRM;
import org.ejml.dense.row.linsol.lu.LinearSolverLu_DDRM;
import org.ejml.dense.row.mult.MatrixVectorMult_DDRM;
import org.ejml.ops.DConvertMatrixStruct;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Kernels of linear algebra: those that are unrolled in Pendant, each beside EJML's. States change,
 * nothing is allocated.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class LinearAlgebraBenchmark {
  /** A power of two: the next state is found by a mask. */
  private static final int STATES = 64;

  private static final ArmDescription ARM = ArmLibrary.load("ur5e");

  private final Jacobian jacobian = new Jacobian(ARM);
  private final double[][] matrices = new double[STATES][Jacobian.SIZE];
  private final double[][] vectors = new double[STATES][6];
  private final double[][] transforms = new double[STATES][Transforms.SIZE];
  private final double[] result = new double[6];
  private final double[] product = new double[Transforms.SIZE];

  private final DMatrixRMaj[] rowMatrices = new DMatrixRMaj[STATES];
  private final DMatrixRMaj[] rowVectors = new DMatrixRMaj[STATES];
  private final DMatrix6x6[] fixedMatrices = new DMatrix6x6[STATES];
  private final DMatrix6[] fixedVectors = new DMatrix6[STATES];
  private final DMatrix4x4[] fixedTransforms = new DMatrix4x4[STATES];
  private final DMatrixRMaj rowResult = new DMatrixRMaj(6, 1);
  private final DMatrix6x6 fixedMatrix = new DMatrix6x6();
  private final DMatrix6 fixedResult = new DMatrix6();
  private final DMatrix4x4 fixedProduct = new DMatrix4x4();
  private final LinearSolverLu_DDRM lu = new LinearSolverLu_DDRM(new LUDecompositionAlt_DDRM());
  private final DMatrixRMaj taken = new DMatrixRMaj(6, 6);
  private int state;

  /** Draws the states. */
  public LinearAlgebraBenchmark() {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < STATES; i++) {
      double[] q = new double[6];
      for (int k = 0; k < 6; k++) {
        q[k] = 3 * (2 * random.nextDouble() - 1);
        vectors[i][k] = 2 * random.nextDouble() - 1;
      }
      jacobian.at(q, Pose.ZERO, matrices[i]);
      Transforms.of(new Pose(q[0], q[1], q[2], q[3], q[4], q[5]), transforms[i]);
      rowMatrices[i] = new DMatrixRMaj(6, 6, true, matrices[i]);
      rowVectors[i] = new DMatrixRMaj(6, 1, true, vectors[i]);
      fixedMatrices[i] = new DMatrix6x6();
      fixedVectors[i] = new DMatrix6();
      fixedTransforms[i] = new DMatrix4x4();
      fill(i);
    }
  }

  private void fill(int i) {
    double[] transform = transforms[i];
    fixedTransforms[i].set(3, 3, 1);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        fixedTransforms[i].set(row, column, transform[3 * row + column]);
      }
      fixedTransforms[i].set(row, 3, transform[9 + row]);
    }
    for (int row = 0; row < 6; row++) {
      fixedVectors[i].set(row, 0, vectors[i][row]);
      for (int column = 0; column < 6; column++) {
        fixedMatrices[i].set(row, column, matrices[i][6 * row + column]);
      }
    }
  }

  private int next() {
    state = (state + 1) & (STATES - 1);
    return state;
  }

  /** Joint speeds of a twist: elimination and substitution. */
  @Benchmark
  public double[] solveOurs() {
    int i = next();
    jacobian.solve(matrices[i], vectors[i], result);
    return result;
  }

  /** The same by EJML's LU, with the copy that it factorises in place. */
  @Benchmark
  public DMatrixRMaj solveEjml() {
    int i = next();
    taken.setTo(rowMatrices[i]);
    lu.setA(taken);
    lu.solve(rowVectors[i], rowResult);
    return rowResult;
  }

  /** A matrix times a vector: the twist of joint speeds. */
  @Benchmark
  public double[] twistOurs() {
    int i = next();
    Jacobian.twist(matrices[i], vectors[i], result);
    return result;
  }

  /** The same by EJML's dense kernel. */
  @Benchmark
  public DMatrixRMaj twistEjmlDense() {
    int i = next();
    MatrixVectorMult_DDRM.mult(rowMatrices[i], rowVectors[i], rowResult);
    return rowResult;
  }

  /** The same by EJML's fixed kernel. */
  @Benchmark
  public DMatrix6 twistEjmlFixed() {
    int i = next();
    CommonOps_DDF6.mult(fixedMatrices[i], fixedVectors[i], fixedResult);
    return fixedResult;
  }

  /**
   * The same by EJML's fixed kernel, from the array in which the rest of Pendant has the matrix.
   */
  @Benchmark
  public DMatrix6 twistEjmlFixedFromArray() {
    int i = next();
    DConvertMatrixStruct.convert(rowMatrices[i], fixedMatrix);
    CommonOps_DDF6.mult(fixedMatrix, fixedVectors[i], fixedResult);
    return fixedResult;
  }

  /** The transposed matrix times a vector. */
  @Benchmark
  public double[] transposedOurs() {
    int i = next();
    Jacobian.transposed(matrices[i], vectors[i], result);
    return result;
  }

  /** The same by EJML's dense kernel. */
  @Benchmark
  public DMatrixRMaj transposedEjmlDense() {
    int i = next();
    MatrixVectorMult_DDRM.multTransA_small(rowMatrices[i], rowVectors[i], rowResult);
    return rowResult;
  }

  /** Two transformations, one after the other. */
  @Benchmark
  public double[] transformsOurs() {
    int i = next();
    Transforms.multiply(transforms[i], transforms[i ^ 1], product);
    return product;
  }

  /** The same by EJML's fixed kernel, last row included. */
  @Benchmark
  public DMatrix4x4 transformsEjmlFixed() {
    int i = next();
    CommonOps_DDF4.mult(fixedTransforms[i], fixedTransforms[i ^ 1], fixedProduct);
    return fixedProduct;
  }
}
