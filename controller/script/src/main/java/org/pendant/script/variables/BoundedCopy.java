package org.pendant.script.variables;

import org.pendant.script.debug.Variables;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Bounded copy: copies values that programs continue to change, as far as a number of parts allows.
 */
final class BoundedCopy {
  /** Bytes of a string that are kept. */
  static final int MAX_BYTES = 1000;

  /** Bytes of a string that count like one part. */
  private static final int BYTES_A_PART = 16;

  private int left;

  /** Copies {@code parts} elements, members and single values, and no more. */
  BoundedCopy(int parts) {
    left = parts;
  }

  /** How many parts it could still copy. */
  int left() {
    return Math.max(0, left);
  }

  /** A value that no program changes, with the first elements where there are too many. */
  Value of(Value value) {
    left--;
    return switch (value) {
      case StringValue string -> start(string);
      case NumberList list -> start(list);
      case ObjectList list -> start(list);
      case MatrixValue matrix -> start(matrix);
      case StructValue struct -> struct(struct);
      default -> value;
    };
  }

  private Value start(StringValue string) {
    left -= Math.min(string.length(), MAX_BYTES) / BYTES_A_PART;
    return Value.of(string.start(MAX_BYTES));
  }

  private Value start(NumberList list) {
    int count = Math.min(list.length(), left());
    left -= count;
    return slice(list, count);
  }

  private static Value slice(ListValue list, int count) {
    try {
      return list.slice(0, count);
    } catch (ScriptError e) {
      throw new IllegalStateException("the first " + count + " of " + list.length(), e);
    }
  }

  private Value start(ObjectList list) {
    int count = Math.min(list.length(), left());
    if (count == 0) {
      return slice(list, 0);
    }
    Value[] copies = new Value[count];
    int copied = 0;
    while (copied < count && (copied == 0 || left > 0)) {
      copies[copied] = of(list.objectAt(copied));
      copied++;
    }
    return ObjectList.owning(copies, copied, copies[0]);
  }

  /** Whole rows, at least one. */
  private Value start(MatrixValue matrix) {
    int rows = Math.clamp(left() / matrix.columns(), 1, matrix.rows());
    double[] numbers = new double[rows * matrix.columns()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = matrix.numberAt(i);
    }
    left -= numbers.length;
    return MatrixValue.owning(rows, matrix.columns(), numbers, matrix.integers());
  }

  /** All members: a struct without some would be another. */
  private Value struct(StructValue struct) {
    Value[] copies = new Value[struct.length()];
    for (int i = 0; i < copies.length; i++) {
      copies[i] = of(struct.memberAt(i));
    }
    return StructValue.owning(struct.names(), copies);
  }

  /** Whether {@code copy} is what {@link #of} would make, provided that nothing had to be cut. */
  static boolean same(Value value, Value copy) {
    return Variables.childCount(value) == Variables.childCount(copy) && value.equals(copy);
  }
}
