package org.pendant.models.kinematics;

import static org.pendant.models.kinematics.KinematicsTexts.text;

import java.util.List;
import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.decomposition.SingularValueDecomposition_F64;
import org.ejml.interfaces.linsol.LinearSolverDense;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Estimate of an arm's calibration from measured poses of its flange, by least squares of the pose
 * errors (Gauss and Newton), a radian for a metre.
 *
 * <p>Denavit-Hartenberg parameters are no unknowns to solve for: along nearly parallel axes they
 * jump with the smallest tilt. The unknowns are, for each link but the last, two shifts and two
 * tilts of the axis that follows (S. Hayati, "Robot arm geometric link parameter estimation", 1983,
 * for the idea), and the length and turn of the last link: {@value #UNKNOWNS} in all, which poses
 * of position and orientation determine. What is found is converted to parameters in the end.
 */
public final class CalibrationEstimate {
  /** Fewer poses leave hardly anything to tell an error of measurement by. */
  public static final int MIN_POSES = 8;

  /**
   * Poses whose equations have a larger condition number leave unknowns open; twenty postures all
   * over the workspace have 2 to 10.
   */
  public static final double MAX_CONDITION = 100;

  private static final int UNKNOWNS = 22;
  private static final int MAX_STEPS = 20;
  private static final int EQUATIONS = 6;

  /** A step that is smaller, in m and rad, changes nothing that matters. */
  private static final double LAST_STEP = 1e-12;

  private final List<MeasuredPose> measured;
  private final double[][] links;
  private final double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
  private final double[] target = new double[Transforms.SIZE];
  private final double[] inverse = new double[Transforms.SIZE];
  private final double[] difference = new double[Transforms.SIZE];
  private final double[] rotation = new double[3];
  private final DMatrixRMaj matrix;
  private final DMatrixRMaj error;
  private final DMatrixRMaj step = new DMatrixRMaj(UNKNOWNS, 1);

  private CalibrationEstimate(ArmDescription arm, List<MeasuredPose> measured) {
    this.measured = measured;
    links = LinkTransforms.of(arm.dh(), DhDeltas.NONE);
    matrix = new DMatrixRMaj(EQUATIONS * measured.size(), UNKNOWNS);
    error = new DMatrixRMaj(EQUATIONS * measured.size(), 1);
  }

  /** What comes of an estimate. */
  public sealed interface Result {
    /**
     * A calibration.
     *
     * @param condition condition number of the equations
     */
    record Estimated(DhDeltas deltas, double condition) implements Result {}

    /**
     * The poses do not tell.
     *
     * @param reason in words for people, with the numbers
     */
    record Refused(String reason) implements Result {}
  }

  /**
   * Estimates the calibration of an arm.
   *
   * @param arm of which the model counts; what calibration it has does not
   */
  public static Result of(ArmDescription arm, List<MeasuredPose> measured) {
    if (measured.size() < MIN_POSES) {
      return new Result.Refused(text("tooFewPoses", measured.size(), MIN_POSES));
    }
    return new CalibrationEstimate(arm, measured).estimate(arm);
  }

  private Result estimate(ArmDescription arm) {
    fill();
    double condition = condition();
    if (!(condition <= MAX_CONDITION)) {
      return new Result.Refused(
          KinematicsTexts.text(
              "openPoses",
              measured.size(),
              String.format(Locale.ROOT, "%.3g", condition),
              String.format(Locale.ROOT, "%.0f", MAX_CONDITION)));
    }
    LinearSolverDense<DMatrixRMaj> solver =
        LinearSolverFactory_DDRM.leastSquares(matrix.getNumRows(), UNKNOWNS);
    for (int count = 0; count < MAX_STEPS; count++) {
      if (!solver.setA(matrix)) {
        return new Result.Refused(text("unsolvable"));
      }
      solver.solve(error, step);
      double largest = apply();
      fill();
      if (largest < LAST_STEP) {
        break;
      }
    }
    DhParameters found = DhConversion.parameters(links, arm.dh());
    return new Result.Estimated(DhDeltas.between(arm.dh(), found), condition);
  }

  private double condition() {
    SingularValueDecomposition_F64<DMatrixRMaj> svd =
        DecompositionFactory_DDRM.svd(matrix.getNumRows(), UNKNOWNS, false, false, true);
    if (!svd.decompose(matrix.copy())) {
      return Double.POSITIVE_INFINITY;
    }
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (int i = 0; i < UNKNOWNS; i++) {
      least = Math.min(least, svd.getSingularValues()[i]);
      most = Math.max(most, svd.getSingularValues()[i]);
    }
    return most / least;
  }

  /** The pose errors of all measurements and how they depend on the unknowns. */
  private void fill() {
    CalibratedChain chain = new CalibratedChain(links);
    for (int n = 0; n < measured.size(); n++) {
      MeasuredPose each = measured.get(n);
      chain.frames(each.positionRad().toArray(), frames);
      Transforms.of(each.flangeInBase(), target);
      double[] flange = frames[Joints.COUNT - 1];
      Transforms.invert(flange, inverse);
      Transforms.multiply(target, inverse, difference);
      Rotations.matrixToVector(difference, rotation);
      int row = EQUATIONS * n;
      for (int axis = 0; axis < 3; axis++) {
        error.set(row + axis, 0, target[9 + axis] - flange[9 + axis]);
        error.set(row + 3 + axis, 0, rotation[axis]);
      }
      int column = 0;
      for (int i = 0; i < Joints.COUNT - 1; i++) {
        shift(row, column++, frames[i], 0);
        shift(row, column++, frames[i], 1);
        turn(row, column++, frames[i], 0);
        turn(row, column++, frames[i], 1);
      }
      shift(row, column++, flange, 2);
      turn(row, column, flange, 2);
    }
  }

  private void shift(int row, int column, double[] frame, int axis) {
    for (int i = 0; i < 3; i++) {
      matrix.set(row + i, column, frame[3 * i + axis]);
      matrix.set(row + 3 + i, column, 0);
    }
  }

  private void turn(int row, int column, double[] frame, int axis) {
    double[] flange = frames[Joints.COUNT - 1];
    double x = flange[9] - frame[9];
    double y = flange[10] - frame[10];
    double z = flange[11] - frame[11];
    double ax = frame[axis];
    double ay = frame[3 + axis];
    double az = frame[6 + axis];
    matrix.set(row, column, ay * z - az * y);
    matrix.set(row + 1, column, az * x - ax * z);
    matrix.set(row + 2, column, ax * y - ay * x);
    matrix.set(row + 3, column, ax);
    matrix.set(row + 4, column, ay);
    matrix.set(row + 5, column, az);
  }

  /** Moves the links by the step and says how large its largest part is. */
  private double apply() {
    double largest = 0;
    for (int i = 0; i < UNKNOWNS; i++) {
      largest = Math.max(largest, Math.abs(step.get(i)));
    }
    double[] change = new double[Transforms.SIZE];
    for (int i = 0; i < Joints.COUNT - 1; i++) {
      Rotations.vectorToMatrix(step.get(4 * i + 2), step.get(4 * i + 3), 0, change);
      change[9] = step.get(4 * i);
      change[10] = step.get(4 * i + 1);
      change[11] = 0;
      move(i, change);
    }
    LinkTransforms.slide(step.get(UNKNOWNS - 1), step.get(UNKNOWNS - 2), change);
    move(Joints.COUNT - 1, change);
    return largest;
  }

  private void move(int i, double[] change) {
    double[] moved = new double[Transforms.SIZE];
    Transforms.multiply(links[i], change, moved);
    links[i] = moved;
  }
}
