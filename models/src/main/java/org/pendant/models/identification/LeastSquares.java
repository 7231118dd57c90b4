package org.pendant.models.identification;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.NormOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.SingularValueDecomposition_F64;

/** Least squares of an overdetermined linear system. */
final class LeastSquares {
  /**
   * Least ratio of the smallest to the largest singular value, of columns of equal length: errors
   * of what was measured reach the result a thousandfold there.
   */
  private static final double MIN_VARIETY = 1e-3;

  private LeastSquares() {}

  /** Whether the rows tell all unknowns apart. */
  static boolean determined(DMatrixRMaj system) {
    if (system.numRows < system.numCols) {
      return false;
    }
    DMatrixRMaj scaled = system.copy();
    for (int column = 0; column < scaled.numCols; column++) {
      double norm = NormOps_DDRM.normF(CommonOps_DDRM.extractColumn(system, column, null));
      if (norm == 0) {
        return false;
      }
      CommonOps_DDRM.scaleCol(1 / norm, scaled, column);
    }
    SingularValueDecomposition_F64<DMatrixRMaj> svd =
        DecompositionFactory_DDRM.svd(scaled.numRows, scaled.numCols, false, false, true);
    if (!svd.decompose(scaled)) {
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

  /** The unknowns, of a system that determines them. */
  static double[] solve(DMatrixRMaj system, DMatrixRMaj measured) {
    DMatrixRMaj unknowns = new DMatrixRMaj(system.numCols, 1);
    if (!CommonOps_DDRM.solve(system, measured, unknowns)) {
      throw new IllegalArgumentException("the system does not determine its unknowns");
    }
    return unknowns.data;
  }

  /** Root of the mean square of what is left, in units of the right side. */
  static double rms(DMatrixRMaj system, double[] unknowns, DMatrixRMaj measured) {
    DMatrixRMaj rest = measured.copy();
    CommonOps_DDRM.multAdd(-1, system, DMatrixRMaj.wrap(unknowns.length, 1, unknowns), rest);
    return NormOps_DDRM.normF(rest) / Math.sqrt(rest.numRows);
  }
}
