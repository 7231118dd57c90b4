package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.models.pose.Poses;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Operators;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Functions and methods of matrices (manual 4.3.3, 17.14, 17.34). */
final class MatrixBuiltins {
  private MatrixBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
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
            call -> {
              MatrixValue matrix = call.matrix(0);
              // each element is in another row, and far from the others in memory
              call.charge(4L * matrix.rows());
              return call.answer(matrix.column(call.integer(1, 0, matrix.columns() - 1)));
            });
    builtins
        .declareMethod(Type.MATRIX, "get_row")
        .manual("core", "4.3.3")
        .doc("A row as a new list.")
        .needs("index", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(
            call -> {
              MatrixValue matrix = call.matrix(0);
              call.charge(matrix.columns());
              return call.answer(matrix.row(call.integer(1, 0, matrix.rows() - 1)));
            });
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

  private static Outcome inverse(Call<?> call) throws ScriptError {
    return switch (call.value(0)) {
      case PoseValue pose -> call.answer(Poses.inverse(pose.pose()));
      case MatrixValue matrix -> inverse(call, matrix);
      default -> throw call.wrongKind(0, text("matrixOrPose"));
    };
  }

  private static Outcome inverse(Call<?> call, MatrixValue matrix) throws ScriptError {
    if (matrix.rows() != matrix.columns()) {
      throw call.failure("wrong-length", text("mustBeSquare", matrix.rows(), matrix.columns()));
    }
    return call.answerLater(() -> Operators.beginInverse(matrix));
  }

  private static Outcome transpose(Call<?> call) throws ScriptError {
    return switch (call.value(0)) {
      case MatrixValue matrix when matrix.columns() == 1 -> call.answer(matrix.column(0));
      case MatrixValue matrix -> call.answerLater(() -> Operators.beginTranspose(matrix));
      case NumberList list when list.length() > 0 && list.elementKind().isNumber() ->
          call.answer(
              MatrixValue.owning(
                  list.length(), 1, call.numbers(0, -1), list.elementKind() == ValueKind.INT));
      default -> throw call.wrongKind(0, text("matrixOrNumbers"));
    };
  }
}
