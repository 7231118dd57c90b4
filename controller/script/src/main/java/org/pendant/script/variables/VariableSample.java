package org.pendant.script.variables;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.debug.Variable;
import org.pendant.script.debug.Variables;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Variable sample: a variable, or a part of one, as it was at one moment. Immutable; one that has
 * not changed since the sample before is the same object.
 */
public final class VariableSample {
  private static final int NO_PART = -1;

  /** An object with its share of what leads to it, rather too much. */
  private static final int BYTES_AN_OBJECT = 64;

  private final String name;
  private final String expression;
  private final Optional<Value> value;
  private final int length;

  /**
   * A sample.
   *
   * @param value no other code may change it; empty for a variable without a value
   * @param length how many elements or members the variable has, of which {@code value} may have
   *     fewer
   */
  VariableSample(String name, String expression, Optional<Value> value, int length) {
    this.name = name;
    this.expression = expression;
    this.value = value;
    this.length = length;
  }

  /**
   * A sample that was taken before, such as one from a recording.
   *
   * @param expression what yields it in the program
   * @param value belongs to the sample from now on; empty for a variable without a value
   * @param length how many elements or members the variable had, at least those of {@code value}
   */
  public static VariableSample of(
      String name, String expression, Optional<Value> value, int length) {
    return new VariableSample(name, expression, value, length);
  }

  /** A variable that was not assigned yet. */
  static VariableSample unassigned(String name) {
    return new VariableSample(name, name, Optional.empty(), 0);
  }

  boolean fits(String wanted, Optional<Value> now, int count) {
    return name.equals(wanted) && length == count && value.equals(now);
  }

  /** The variable's name; as in {@link Variable#name} for a part. */
  public String name() {
    return name;
  }

  /** What yields it in the program. */
  public String expression() {
    return expression;
  }

  /** An independent copy of its value, cut where it is long; empty before it was assigned. */
  public Optional<Value> value() {
    return value.map(Value::copy);
  }

  /** The kind of its value; empty before it was assigned. */
  public Optional<ValueKind> kind() {
    return value.map(Value::kind);
  }

  Optional<Value> shared() {
    return value;
  }

  /** How many elements or members it has, also those that were cut off. */
  public int length() {
    return length;
  }

  /** How many of them the sample has. */
  public int kept() {
    return value.map(Variables::childCount).orElse(0);
  }

  /** What its value takes in memory, about; costs a look at each part. */
  public long bytes() {
    return value.map(VariableSample::bytes).orElse(0L);
  }

  private static long bytes(Value value) {
    long sum = BYTES_AN_OBJECT;
    switch (value) {
      case StringValue string -> sum += string.length();
      case NumberList list -> sum += (long) Double.BYTES * list.length();
      case MatrixValue matrix -> sum += (long) Double.BYTES * matrix.rows() * matrix.columns();
      case ObjectList list -> {
        for (int i = 0; i < list.length(); i++) {
          sum += bytes(list.objectAt(i));
        }
      }
      case StructValue struct -> {
        for (int i = 0; i < struct.length(); i++) {
          sum += bytes(struct.memberAt(i));
        }
      }
      default -> {
        // as small as any object
      }
    }
    return sum;
  }

  /** Ready to be shown; costs more than a look. */
  public Variable variable() {
    return value
        .map(
            present -> {
              Variable made = Variables.of(name, expression, present);
              return new Variable(name, expression, made.kind(), made.text(), length);
            })
        .orElseGet(() -> new Variable(name, expression, Optional.empty(), "", 0));
  }

  /** The first {@code most} elements or members, or as many as the sample has. */
  public List<VariableSample> parts(int most) {
    List<VariableSample> parts = new ArrayList<>();
    for (int i = 0; i < Math.min(most, kept()); i++) {
      parts.add(part(i));
    }
    return parts;
  }

  private VariableSample part(int index) {
    Variables.Part part = Variables.part(expression, value.orElseThrow(), index);
    return new VariableSample(
        part.name(),
        part.expression(),
        Optional.of(part.value()),
        Variables.childCount(part.value()));
  }

  /** The part that {@code steps} lead to, if the sample has it. */
  Optional<VariableSample> part(List<VariablePath.Selector> steps) {
    if (steps.isEmpty()) {
      return Optional.of(this);
    }
    int taken = 1;
    int index = NO_PART;
    if (steps.getFirst() instanceof VariablePath.Selector.Member member) {
      index = value.map(present -> member(present, member.name())).orElse(NO_PART);
    } else if (steps.getFirst() instanceof VariablePath.Selector.Element element) {
      if (value.isPresent() && value.get() instanceof MatrixValue matrix) {
        taken = 2;
        index = inMatrix(matrix, element.index(), steps);
      } else {
        index = element.index();
      }
    }
    return index >= 0 && index < kept()
        ? part(index).part(steps.subList(taken, steps.size()))
        : Optional.empty();
  }

  private static int member(Value value, String name) {
    return value instanceof StructValue struct ? struct.names().indexOf(name) : NO_PART;
  }

  private static int inMatrix(MatrixValue matrix, int row, List<VariablePath.Selector> steps) {
    return steps.size() > 1
            && steps.get(1) instanceof VariablePath.Selector.Element column
            && column.index() < matrix.columns()
            && row < matrix.rows()
        ? row * matrix.columns() + column.index()
        : NO_PART;
  }
}
