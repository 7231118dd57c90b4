package org.pendant.script.value;

/** Equality: the {@code ==} of scripts, see {@link Operators#equal}. */
final class Equality {
  private Equality() {}

  static boolean equal(Value left, Value right) {
    if (scalar(left) && scalar(right)) {
      return number(left) == number(right);
    }
    return switch (left) {
      case StringValue a -> right instanceof StringValue b && a.bytes().equals(b.bytes());
      case PoseValue a -> right instanceof PoseValue b && poses(a, b);
      case NumberList a when right instanceof NumberList b ->
          a.length() == b.length() && numbers(a.elements(), b.elements(), 0, a.length());
      case ObjectList a when right instanceof ObjectList b -> objects(a, b);
      case ListValue a -> right instanceof ListValue b && a.length() == 0 && b.length() == 0;
      case MatrixValue a -> right instanceof MatrixValue b && matrices(a, b);
      case StructValue a -> right instanceof StructValue b && structs(a, b);
      case HandleValue a -> right instanceof HandleValue b && a.equals(b);
      case NoneValue none -> right.kind() == ValueKind.NONE;
      case BoolValue b -> false;
      case IntValue i -> false;
      case FloatValue f -> false;
    };
  }

  private static boolean scalar(Value value) {
    return value.kind().isNumber() || value.kind() == ValueKind.BOOL;
  }

  private static double number(Value value) {
    return value instanceof BoolValue b ? (b.value() ? 1 : 0) : Operators.number(value);
  }

  private static boolean poses(PoseValue a, PoseValue b) {
    for (int i = 0; i < 6; i++) {
      if (a.pose().get(i) != b.pose().get(i)) {
        return false;
      }
    }
    return true;
  }

  /** Whether numbers {@code from} .. {@code to}-1 are equal. */
  static boolean numbers(double[] a, double[] b, int from, int to) {
    for (int i = from; i < to; i++) {
      if (a[i] != b[i]) {
        return false;
      }
    }
    return true;
  }

  private static boolean objects(ObjectList a, ObjectList b) {
    if (a.length() != b.length()) {
      return false;
    }
    for (int i = 0; i < a.length(); i++) {
      if (!equal(a.objectAt(i), b.objectAt(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean matrices(MatrixValue a, MatrixValue b) {
    return a.rows() == b.rows()
        && a.columns() == b.columns()
        && numbers(a.elements(), b.elements(), 0, a.elements().length);
  }

  private static boolean structs(StructValue a, StructValue b) {
    if (!a.names().equals(b.names())) {
      return false;
    }
    for (int i = 0; i < a.length(); i++) {
      if (!equal(a.memberAt(i), b.memberAt(i))) {
        return false;
      }
    }
    return true;
  }
}
