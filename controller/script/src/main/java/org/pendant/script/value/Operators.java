package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

import java.util.List;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.models.text.FloatText;

/**
 * Operators: what operators, indices and member accesses of a script do with any values (manual 3
 * to 5). The machine computes plain numbers itself and asks here for the rest; the answers are the
 * same.
 *
 * <p>Results are new values unless a method says otherwise; no operand is changed.
 */
public final class Operators {
  /** Most bytes a string may have that {@code +} puts together; protects the host's memory. */
  public static final int MAX_STRING_LENGTH = 1 << 20;

  private Operators() {}

  /**
   * The value of {@code left operator right}; both sides of {@code and} and {@code or} are looked
   * at.
   *
   * @throws ScriptError for kinds that the operator cannot combine, for a division by zero and for
   *     an int result that does not fit 32 bits
   */
  public static Value binary(BinaryOperator operator, Value left, Value right) throws ScriptError {
    return switch (operator) {
      case OR, XOR, AND -> Value.of(logical(operator, left, right));
      case EQUAL -> Value.of(equal(left, right));
      case NOT_EQUAL -> Value.of(!equal(left, right));
      case LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL ->
          Value.of(ordered(operator, left, right));
      case ADD, SUBTRACT, MULTIPLY, DIVIDE, MODULO -> arithmetic(operator, left, right);
    };
  }

  /** Whether {@code left operator right} is something that {@link #begin} begins. */
  public static boolean elementwise(BinaryOperator operator, Value left, Value right) {
    boolean many = many(left) || many(right);
    return many && !(operator == BinaryOperator.ADD && right instanceof StructValue);
  }

  private static boolean many(Value value) {
    return value instanceof NumberList || value instanceof MatrixValue;
  }

  /**
   * Begins arithmetic with at least one list or matrix.
   *
   * @throws ScriptError for kinds and shapes that the operator cannot combine
   */
  public static LongOperation begin(BinaryOperator operator, Value left, Value right)
      throws ScriptError {
    return Elementwise.begin(operator, left, right);
  }

  /** The value of {@code -operand}: a number, or a list or matrix of numbers. */
  public static Value negate(Value operand) throws ScriptError {
    return switch (operand) {
      case IntValue i -> integer("-", -(long) i.value());
      case FloatValue f -> Value.of(-f.value());
      case NumberList list when list.elementKind().isNumber() ->
          Elementwise.apply(BinaryOperator.SUBTRACT, Value.of(0), list);
      case MatrixValue matrix -> Elementwise.apply(BinaryOperator.SUBTRACT, Value.of(0), matrix);
      default ->
          throw new ScriptError(
              "wrong-type",
              operand.kind() == ValueKind.POSE
                  ? text("cannotNegatePose", described(operand))
                  : text("cannotNegate", described(operand)));
    };
  }

  /** The value of {@code not operand}. */
  public static Value not(Value operand) throws ScriptError {
    return Value.of(!truth("not", operand));
  }

  /**
   * Whether {@code value} counts as true in a condition: a bool, a number that is not zero, or a
   * string that is not empty (manual 18.61).
   *
   * @throws ScriptError for every other kind
   */
  public static boolean truth(Value value) throws ScriptError {
    return truth("condition", value);
  }

  private static boolean truth(String where, Value value) throws ScriptError {
    return switch (value) {
      case BoolValue b -> b.value();
      case IntValue i -> i.value() != 0;
      case FloatValue f -> f.value() != 0;
      case StringValue s -> s.length() != 0;
      default -> throw new ScriptError("wrong-type", text("noBool", where, described(value)));
    };
  }

  /**
   * Whether {@code left == right}. Numbers are equal by value, whether int or float, and exactly; a
   * bool equals the numbers 1 or 0; lists, matrices and structs are equal by content, lists of
   * different length never. Values of different kinds are not equal: no comparison is an error,
   * since programs test results of unknown kind against {@code None} or a literal.
   */
  public static boolean equal(Value left, Value right) {
    return Equality.equal(left, right);
  }

  /** Begins what {@link #equal(Value, Value)} does at once; the result is a bool. */
  public static LongOperation beginEqual(Value left, Value right) {
    return new Comparison(left, right);
  }

  /**
   * The value of the literal {@code [elements]}: a list with the capacity of its length, or a
   * matrix when the elements are lists of numbers of equal length. An empty one is an empty list of
   * int. Elements are copied.
   *
   * @throws ScriptError when the elements are not of one type
   */
  public static Value listLiteral(List<Value> elements) throws ScriptError {
    return ListLiterals.of(elements.toArray(new Value[0]));
  }

  /**
   * Begins a matrix whose rows are the lists {@code rows}.
   *
   * @param rows at least one, the first a list
   * @throws ScriptError when they are not lists of equally many numbers
   */
  public static LongOperation beginMatrix(Value... rows) throws ScriptError {
    return ListLiterals.matrix(rows);
  }

  /** As {@link #listLiteral(List)}. */
  public static Value listLiteral(Value... elements) throws ScriptError {
    return ListLiterals.of(elements);
  }

  /** As {@link #listLiteral(List)}, of the {@code count} registers from {@code first}. */
  public static Value listLiteral(Registers registers, int first, int count) throws ScriptError {
    return ListLiterals.of(registers, first, count);
  }

  /**
   * {@code receiver[index]}: an element of a list, a component of a pose, a member of a struct, a
   * row of a matrix (a new list). Elements and members are not copied. A float without fraction is
   * an index, too.
   */
  public static Value index(Value receiver, Value index) throws ScriptError {
    return Access.get(receiver, index);
  }

  /** As {@link #index(Value, Value)}, of a container that is changed: so is what this answers. */
  public static Value open(Value receiver, Value index) throws ScriptError {
    return Access.open(receiver, index);
  }

  /** {@code receiver[row, column]} of a matrix. */
  public static Value index(Value receiver, Value row, Value column) throws ScriptError {
    return Access.get(receiver, row, column);
  }

  /**
   * {@code receiver[index] = element}: changes {@code receiver} and answers it, or answers the new
   * pose when it is a pose. Element types are kept; a matrix takes no whole rows.
   *
   * @param element fresh: the receiver owns it afterwards
   */
  public static Value setIndex(Value receiver, Value index, Value element) throws ScriptError {
    return Access.set(receiver, index, element);
  }

  /** {@code receiver[row, column] = element}: changes the matrix and answers it. */
  public static Value setIndex(Value receiver, Value row, Value column, Value element)
      throws ScriptError {
    return Access.set(receiver, row, column, element);
  }

  /** {@code receiver.name}: a member of a struct, not copied. */
  public static Value member(Value receiver, String name) throws ScriptError {
    return Access.struct(receiver, name).get(name);
  }

  /** As {@link #member}, of a struct that is changed: so is what this answers. */
  public static Value openMember(Value receiver, String name) throws ScriptError {
    return Access.struct(receiver, name).open(name);
  }

  /** {@code receiver.name = element}; {@code element} is fresh. Answers the struct. */
  public static Value setMember(Value receiver, String name, Value element) throws ScriptError {
    Access.struct(receiver, name).set(name, element);
    return receiver;
  }

  /**
   * What a variable that holds {@code current} holds after {@code incoming} was assigned to it. Its
   * type was fixed by the first assignment (manual 3), with int and float as one type, and:
   *
   * <ul>
   *   <li>a list keeps its capacity, and takes only what fits (manual 4.2); {@code current} itself
   *       is changed and answered;
   *   <li>a struct takes only the same members, each by these rules; it is changed and answered;
   *   <li>a matrix takes only the same number of rows and columns;
   *   <li>a variable that holds {@code None} has no type yet and takes anything.
   * </ul>
   *
   * @param incoming fresh: the variable owns it afterwards
   * @throws ScriptError {@code wrong-type} or {@code list-capacity}
   */
  public static Value assign(Value current, Value incoming) throws ScriptError {
    return Assignment.assign(current, incoming);
  }

  /** Begins the inverse of a square matrix, whose result fails if there is none. */
  public static LongOperation beginInverse(MatrixValue matrix) {
    return new MatrixInverse(matrix);
  }

  /** Begins the matrix whose rows are the columns of {@code matrix}. */
  public static LongOperation beginTranspose(MatrixValue matrix) {
    return new MatrixTranspose(matrix);
  }

  private static boolean logical(BinaryOperator operator, Value left, Value right)
      throws ScriptError {
    boolean a = truth(operator.text(), left);
    boolean b = truth(operator.text(), right);
    return switch (operator) {
      case OR -> a || b;
      case XOR -> a ^ b;
      case AND -> a && b;
      default -> throw new IllegalArgumentException(operator.text() + " is not logical");
    };
  }

  private static Value arithmetic(BinaryOperator operator, Value left, Value right)
      throws ScriptError {
    if (left instanceof IntValue a && right instanceof IntValue b) {
      return integers(operator, a.value(), b.value());
    }
    if (left.kind().isNumber() && right.kind().isNumber()) {
      return Value.of(floats(operator, number(left), number(right)));
    }
    if (operator == BinaryOperator.ADD) {
      if (left instanceof StringValue a && right instanceof StringValue b) {
        return concatenated(a, b);
      }
      if (left instanceof ListValue list && right instanceof StructValue struct) {
        return ListLiterals.added(list, struct);
      }
    }
    return Elementwise.apply(operator, left, right);
  }

  private static Value integers(BinaryOperator operator, int left, int right) throws ScriptError {
    return switch (operator) {
      case ADD -> integer(operator.text(), (long) left + right);
      case SUBTRACT -> integer(operator.text(), (long) left - right);
      case MULTIPLY -> integer(operator.text(), (long) left * right);
      case DIVIDE -> Value.of(floats(operator, left, right));
      case MODULO -> Value.of((int) floats(operator, left, right));
      default -> throw new IllegalArgumentException(operator.text() + " is not arithmetic");
    };
  }

  /** Dividing by zero is refused; a remainder has the sign of the dividend, as C's fmod. */
  private static double floats(BinaryOperator operator, double left, double right)
      throws ScriptError {
    return switch (operator) {
      case ADD -> left + right;
      case SUBTRACT -> left - right;
      case MULTIPLY -> left * right;
      case DIVIDE -> left / divisor(operator, right);
      case MODULO -> left % divisor(operator, right);
      default -> throw new IllegalArgumentException(operator.text() + " is not arithmetic");
    };
  }

  private static double divisor(BinaryOperator operator, double right) throws ScriptError {
    if (right == 0) {
      throw divisionByZero(operator);
    }
    return right;
  }

  static ScriptError divisionByZero(BinaryOperator operator) {
    return new ScriptError("division-by-zero", text("divisionByZero", operator.text()));
  }

  static ScriptError integerOverflow(String operator, double result) {
    return new ScriptError(
        "integer-overflow", text("integerOverflow", operator, FloatText.of(result)));
  }

  private static Value integer(String operator, long result) throws ScriptError {
    if (result != (int) result) {
      throw integerOverflow(operator, (double) result);
    }
    return Value.of((int) result);
  }

  /**
   * One string after the other.
   *
   * @throws ScriptError when the result would have more than 2^20 bytes
   */
  public static StringValue concatenated(StringValue left, StringValue right) throws ScriptError {
    int length = left.length() + right.length();
    if (length > MAX_STRING_LENGTH) {
      throw new ScriptError("string-too-long", text("stringTooLong", length, MAX_STRING_LENGTH));
    }
    return left.followedBy(right);
  }

  private static boolean ordered(BinaryOperator operator, Value left, Value right)
      throws ScriptError {
    if (!left.kind().isNumber() || !right.kind().isNumber()) {
      throw new ScriptError(
          "wrong-type", text("notOrdered", operator.text(), described(left), described(right)));
    }
    double a = number(left);
    double b = number(right);
    return switch (operator) {
      case LESS -> a < b;
      case GREATER -> a > b;
      case LESS_OR_EQUAL -> a <= b;
      case GREATER_OR_EQUAL -> a >= b;
      default -> throw new IllegalArgumentException(operator.text() + " is not an order");
    };
  }

  /** The number of an int or float. */
  static double number(Value value) {
    return switch (value) {
      case IntValue i -> i.value();
      case FloatValue f -> f.value();
      default -> throw new IllegalArgumentException(value.kind().text() + " is not a number");
    };
  }

  static ScriptError cannotCombine(BinaryOperator operator, Value left, Value right) {
    return new ScriptError(
        "wrong-type",
        text(
            uncombined(operator, left, right), operator.text(), described(left), described(right)));
  }

  /** The text for two values that an operator cannot combine, with what would be right. */
  private static String uncombined(BinaryOperator operator, Value left, Value right) {
    boolean oneString = left.kind() == ValueKind.STRING ^ right.kind() == ValueKind.STRING;
    if (operator == BinaryOperator.ADD && oneString) {
      return "cannotCombineString";
    }
    boolean pose = left.kind() == ValueKind.POSE || right.kind() == ValueKind.POSE;
    return pose ? "cannotCombinePose" : "cannotCombine";
  }

  /** What a value is, for messages: {@code a list of 3 int}, {@code a 2 x 3 matrix}. */
  static String described(Value value) {
    return switch (value) {
      case ListValue list ->
          list.length() == 0
              ? text("anEmptyList")
              : text("aListOf", list.length(), list.elementKind().text());
      case MatrixValue matrix -> text("matrixShape", matrix.rows(), matrix.columns());
      default -> value.kind().described();
    };
  }
}
