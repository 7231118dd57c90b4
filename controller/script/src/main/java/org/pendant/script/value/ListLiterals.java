package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

import java.util.Optional;
import org.pendant.language.syntax.Expression.BinaryOperator;

/** List literals: lists and matrices made of single values, see {@link Operators#listLiteral}. */
final class ListLiterals {
  private ListLiterals() {}

  static Value of(Registers registers, int first, int count) throws ScriptError {
    byte[] tags = registers.tags();
    int all = 0;
    for (int i = 0; i < count; i++) {
      all |= tags[first + i];
    }
    if (all <= Registers.FLOAT) {
      double[] elements = new double[count];
      System.arraycopy(registers.numbers(), first, elements, 0, count);
      return NumberList.owning(
          elements, count, all == Registers.INT ? ValueKind.INT : ValueKind.FLOAT);
    }
    Value[] elements = new Value[count];
    for (int i = 0; i < count; i++) {
      elements[i] = registers.value(first + i);
    }
    return of(elements);
  }

  static Value of(Value... elements) throws ScriptError {
    if (elements.length == 0) {
      return NumberList.ofInts();
    }
    return switch (elements[0].kind()) {
      case BOOL, INT, FLOAT -> scalars(elements);
      case LIST -> LongOperation.finish(matrix(elements));
      case STRING, POSE, STRUCT, HANDLE -> objects(elements);
      case NONE, MATRIX ->
          throw new ScriptError(
              "wrong-type", text("listCannotHold", Operators.described(elements[0])));
    };
  }

  private static NumberList scalars(Value... elements) throws ScriptError {
    ValueKind kind = elements[0].kind();
    double[] numbers = new double[elements.length];
    for (int i = 0; i < numbers.length; i++) {
      ValueKind found = elements[i].kind();
      if (!kind.accepts(found)) {
        throw mixed(i, kind.described(), elements[i]);
      }
      if (found == ValueKind.FLOAT) {
        kind = ValueKind.FLOAT;
      }
      numbers[i] =
          elements[i] instanceof BoolValue b ? (b.value() ? 1 : 0) : Operators.number(elements[i]);
    }
    return NumberList.owning(numbers, numbers.length, kind);
  }

  private static ObjectList objects(Value... elements) throws ScriptError {
    Value[] copies = new Value[elements.length];
    for (int i = 0; i < copies.length; i++) {
      Optional<String> difference = StructValue.typeDifference(elements[0], elements[i]);
      if (difference.isPresent()) {
        throw new ScriptError("wrong-type", text("mixedElements", difference.get()));
      }
      copies[i] = elements[i].copy();
    }
    return ObjectList.owning(copies, copies.length, elements[0].copy());
  }

  /**
   * Begins a matrix of {@code rows}, of which the first is a list.
   *
   * @throws ScriptError when they are no rows of a matrix
   */
  static LongOperation matrix(Value... rows) throws ScriptError {
    int columns = ((ListValue) rows[0]).length();
    if (columns == 0) {
      throw new ScriptError("wrong-length", text("matrixWithoutColumns"));
    }
    NumberList[] lists = new NumberList[rows.length];
    for (int i = 0; i < rows.length; i++) {
      if (!(rows[i] instanceof NumberList row && row.elementKind().isNumber())) {
        throw new ScriptError("wrong-type", text("matrixRowType", i, Operators.described(rows[i])));
      }
      if (row.length() != columns) {
        throw new ScriptError("wrong-length", text("matrixRowLength", i, row.length(), columns));
      }
      lists[i] = row;
    }
    MatrixValue.check(rows.length, columns);
    return new MatrixRows(lists);
  }

  /**
   * {@code list + struct}, where all members have one type, that of the list (manual 4.1.1). The
   * members become a list; numbers are then added element by element as two lists are, so that a
   * list of zeros gives the members themselves. Other types cannot be added: there, and when the
   * list is empty, the members take the place of the elements.
   */
  static Value added(ListValue list, StructValue struct) throws ScriptError {
    Value[] members = new Value[struct.length()];
    for (int i = 0; i < members.length; i++) {
      members[i] = struct.memberAt(i);
    }
    if (!(of(members) instanceof ListValue converted)
        || (list.length() > 0 && !list.elementKind().accepts(converted.elementKind()))) {
      throw Operators.cannotCombine(BinaryOperator.ADD, list, struct);
    }
    if (list.length() > 0 && list.elementKind().isNumber()) {
      return Elementwise.apply(BinaryOperator.ADD, list, converted);
    }
    return converted;
  }

  private static ScriptError mixed(int index, String expected, Value found) {
    return new ScriptError(
        "wrong-type", text("mixedElement", index, Operators.described(found), expected));
  }
}
