package org.pendant.controller.builtin;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.NormOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.call.Call;
import org.pendant.controller.call.Effect;
import org.pendant.controller.call.Outcome;
import org.pendant.controller.value.Kind;
import org.pendant.controller.value.MatrixValue;
import org.pendant.controller.value.NumberList;
import org.pendant.controller.value.PoseValue;
import org.pendant.controller.value.ScriptError;
import org.pendant.language.signature.Type;
import org.pendant.models.pose.Poses;

/** Functions and methods of matrices (manual 4.3.3, 17.14, 17.34). */
final class MatrixBuiltins {
  private static final String SINGULAR = "matrix-singular";

  /**
   * Smallest reciprocal condition number of a matrix that counts as invertible: at the precision of
   * a double, below it not one digit of an inverse would be right.
   */
  private static final double SMALLEST_RECIPROCAL_CONDITION = 1e-15;

  private MatrixBuiltins() {}

  static void declareIn(Builtins builtins) {
    builtins
        .declare("inv")
        .manual("urmath", "17.14")
        .doc("The inverse of a square matrix or of a pose. A singular matrix is an error.")
        .needs("m", Type.ANY)
        .returns(Type.ANY)
        .effect(Effect.COMPUTES)
        .does(MatrixBuiltins::inverse);
    builtins
        .declare("transpose")
        .manual("urmath", "17.34")
        .doc(
            "Exchanges the rows and columns of a matrix. A list becomes a matrix of one column, and"
                + " such a matrix a list.")
        .needs("m", Type.ANY)
        .returns(Type.ANY)
        .effect(Effect.COMPUTES)
        .does(MatrixBuiltins::transpose);
    builtins
        .declareMethod(Type.MATRIX, "get_column")
        .manual("core", "4.3.3")
        .doc("A column as a new list.")
        .needs("index", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(
            call ->
                call.answer(
                    call.matrix(0).column(call.integer(1, 0, call.matrix(0).columns() - 1))));
    builtins
        .declareMethod(Type.MATRIX, "get_row")
        .manual("core", "4.3.3")
        .doc("A row as a new list.")
        .needs("index", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(
            call -> call.answer(call.matrix(0).row(call.integer(1, 0, call.matrix(0).rows() - 1))));
    builtins
        .declareMethod(Type.MATRIX, "shape")
        .manual("core", "4.3.3")
        .doc("The numbers of rows and columns, as a list of two.")
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(shape(call.matrix(0))));
    builtins
        .declareMethod(Type.MATRIX, "to_string")
        .manual("core", "4.3.3")
        .doc("The matrix as text, shortened with ...] beyond 1023 characters.")
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::toStringMethod);
  }

  static NumberList shape(MatrixValue matrix) {
    return NumberList.ofInts(matrix.rows(), matrix.columns());
  }

  private static Outcome inverse(Call call) throws ScriptError {
    return switch (call.value(0)) {
      case PoseValue pose -> call.answer(Poses.inverse(pose.pose()));
      case MatrixValue matrix -> call.answer(inverse(call, matrix));
      default -> throw call.wrongKind(0, "a matrix or a pose");
    };
  }

  private static MatrixValue inverse(Call call, MatrixValue matrix) throws ScriptError {
    int size = matrix.rows();
    if (size != matrix.columns()) {
      throw call.failure(
          "wrong-length",
          "m has " + size + " rows and " + matrix.columns() + " columns, must be square");
    }
    DMatrixRMaj original = new DMatrixRMaj(size, size);
    for (int i = 0; i < size * size; i++) {
      original.data[i] = matrix.numberAt(i);
    }
    DMatrixRMaj inverted = new DMatrixRMaj(size, size);
    LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.lu(size);
    boolean solved = solver.setA(original.copy());
    if (solved) {
      solver.invert(inverted);
    }
    if (!solved || !trustworthy(original, inverted)) {
      throw call.failure(SINGULAR, "m is singular, it has no inverse");
    }
    return MatrixValue.owning(size, size, inverted.data, false);
  }

  /** Whether the inverse is made of numbers, and the matrix not singular but for rounding. */
  private static boolean trustworthy(DMatrixRMaj original, DMatrixRMaj inverted) {
    double condition = NormOps_DDRM.normP1(original) * NormOps_DDRM.normP1(inverted);
    return !MatrixFeatures_DDRM.hasUncountable(inverted)
        && 1 / condition > SMALLEST_RECIPROCAL_CONDITION;
  }

  private static Outcome transpose(Call call) throws ScriptError {
    return switch (call.value(0)) {
      case MatrixValue matrix when matrix.columns() == 1 -> call.answer(matrix.column(0));
      case MatrixValue matrix -> call.answer(transposed(matrix));
      case NumberList list when list.length() > 0 && list.elementKind().isNumber() ->
          call.answer(
              MatrixValue.owning(
                  list.length(), 1, call.numbers(0, -1), list.elementKind() == Kind.INT));
      default -> throw call.wrongKind(0, "a matrix or a list of numbers");
    };
  }

  private static MatrixValue transposed(MatrixValue matrix) {
    int rows = matrix.rows();
    int columns = matrix.columns();
    double[] elements = new double[rows * columns];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        elements[column * rows + row] = matrix.numberAt(row * columns + column);
      }
    }
    return MatrixValue.owning(columns, rows, elements, matrix.integers());
  }
}
