package org.pendant.models.dynamics;

import static org.pendant.models.dynamics.DynamicsTexts.text;

import java.util.List;
import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.SingularValueDecomposition_F64;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Wrench;

/**
 * Payload equations: the two systems of {@link PayloadEstimate}: forces tell the mass, torques the
 * first moment. Unknowns are scaled by gravity, so that all coefficients are of one size.
 */
final class PayloadEquations {
  /** Gravity below this, m/s², gives a load no weight. */
  private static final double MIN_GRAVITY_M_PER_S2 = 0.1;

  /**
   * Least ratio of the smallest to the largest singular value: errors of the measurements reach the
   * result a hundredfold there. Without any tilt against gravity it is 0.
   */
  private static final double MIN_VARIETY = 0.01;

  private final List<Pose> flangesInBase;
  private final List<Wrench> wrenchesInBase;
  private final double gravityMPerS2;
  private final double upX;
  private final double upY;
  private final double upZ;

  PayloadEquations(List<Pose> flanges, List<Wrench> wrenches, double gx, double gy, double gz) {
    flangesInBase = flanges;
    wrenchesInBase = wrenches;
    gravityMPerS2 = Math.sqrt(gx * gx + gy * gy + gz * gz);
    upX = gx / gravityMPerS2;
    upY = gy / gravityMPerS2;
    upZ = gz / gravityMPerS2;
  }

  PayloadEstimate solve() {
    if (!(gravityMPerS2 >= MIN_GRAVITY_M_PER_S2)) {
      return new PayloadEstimate.Refused(text("noWeight", gravityMPerS2));
    }
    int rows = 3 * flangesInBase.size();
    // unknown: weight m |a| and the zero of the forces
    DMatrixRMaj force = new DMatrixRMaj(rows, 4);
    DMatrixRMaj forces = new DMatrixRMaj(rows, 1);
    // unknown: moments h |a| and the zero of the torques
    DMatrixRMaj torque = new DMatrixRMaj(rows, 6);
    DMatrixRMaj torques = new DMatrixRMaj(rows, 1);
    double[] r = new double[9];
    for (int i = 0; i < flangesInBase.size(); i++) {
      Pose flange = flangesInBase.get(i);
      Rotations.vectorToMatrix(flange.rx(), flange.ry(), flange.rz(), r);
      fillForce(3 * i, r, force);
      fillTorque(3 * i, r, torque);
      Wrench wrench = wrenchesInBase.get(i);
      set(forces, 3 * i, 0, wrench.fx(), wrench.fy(), wrench.fz());
      set(torques, 3 * i, 0, wrench.mx(), wrench.my(), wrench.mz());
    }
    if (!telling(force) || !telling(torque)) {
      return new PayloadEstimate.Refused(text("hardlyTilted"));
    }
    double massKg = solution(force, forces).get(0) / gravityMPerS2;
    if (massKg < -PayloadEstimate.MIN_MASS_KG) {
      return new PayloadEstimate.Refused(
          DynamicsTexts.text("pullsAgainstGravity", String.format(Locale.ROOT, "%.3f", massKg)));
    }
    if (massKg < PayloadEstimate.MIN_MASS_KG) {
      return new PayloadEstimate.Found(Payload.NONE);
    }
    DMatrixRMaj moments = solution(torque, torques);
    double weightN = massKg * gravityMPerS2;
    return new PayloadEstimate.Found(
        Payload.of(
            massKg, moments.get(0) / weightN, moments.get(1) / weightN, moments.get(2) / weightN));
  }

  private void fillForce(int row, double[] r, DMatrixRMaj force) {
    set(force, row, 0, -upX, -upY, -upZ);
    for (int axis = 0; axis < 3; axis++) {
      set(force, row, 1 + axis, r[axis], r[3 + axis], r[6 + axis]);
    }
  }

  private void fillTorque(int row, double[] r, DMatrixRMaj torque) {
    for (int axis = 0; axis < 3; axis++) {
      double x = r[axis];
      double y = r[3 + axis];
      double z = r[6 + axis];
      set(torque, row, axis, upY * z - upZ * y, upZ * x - upX * z, upX * y - upY * x);
      set(torque, row, 3 + axis, x, y, z);
    }
  }

  private static void set(DMatrixRMaj matrix, int row, int column, double x, double y, double z) {
    matrix.set(row, column, x);
    matrix.set(row + 1, column, y);
    matrix.set(row + 2, column, z);
  }

  private static boolean telling(DMatrixRMaj system) {
    SingularValueDecomposition_F64<DMatrixRMaj> svd =
        DecompositionFactory_DDRM.svd(system.getNumRows(), system.getNumCols(), false, false, true);
    if (!svd.decompose(system.copy())) {
      return false;
    }
    double smallest = Double.POSITIVE_INFINITY;
    double largest = 0;
    for (int i = 0; i < svd.numberOfSingularValues(); i++) {
      smallest = Math.min(smallest, svd.getSingularValues()[i]);
      largest = Math.max(largest, svd.getSingularValues()[i]);
    }
    return smallest >= MIN_VARIETY * largest;
  }

  private static DMatrixRMaj solution(DMatrixRMaj system, DMatrixRMaj measured) {
    DMatrixRMaj unknowns = new DMatrixRMaj(system.getNumCols(), 1);
    CommonOps_DDRM.solve(system, measured, unknowns);
    return unknowns;
  }
}
