package org.pendant.script.variables;

import java.util.List;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Registers;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Path reader: follows the path to one number without making anything; what is no number reads as
 * NaN.
 */
final class PathReader {
  private final VariablePath.Selector[] steps;

  PathReader(VariablePath path) {
    steps = path.steps().toArray(VariablePath.Selector[]::new);
  }

  /** The number that the variable in {@code slot} has there now; booleans are 0 and 1. */
  double read(Registers registers, int slot) {
    byte tag = registers.tags()[slot];
    if (tag == Registers.INT || tag == Registers.FLOAT || tag == Registers.BOOL) {
      return steps.length == 0 ? registers.numbers()[slot] : Double.NaN;
    }
    return tag == Registers.OBJECT ? read(registers.objects()[slot], 0) : Double.NaN;
  }

  /** The number in {@code value} that is {@code done} steps on the way. */
  private double read(Value value, int done) {
    if (done == steps.length) {
      return scalar(value);
    }
    return switch (steps[done]) {
      case VariablePath.Selector.Element element -> element(value, element.index(), done + 1);
      case VariablePath.Selector.Member member -> member(value, member.name(), done + 1);
    };
  }

  private static double scalar(Value value) {
    if (value instanceof FloatValue number) {
      return number.value();
    }
    if (value instanceof IntValue number) {
      return number.value();
    }
    return value instanceof BoolValue bool ? (bool.value() ? 1 : 0) : Double.NaN;
  }

  private double element(Value value, int index, int done) {
    boolean last = done == steps.length;
    if (value instanceof NumberList list) {
      return last && index < list.length() ? list.numberAt(index) : Double.NaN;
    }
    if (value instanceof PoseValue pose) {
      return last && index < Pose.SIZE ? pose.pose().get(index) : Double.NaN;
    }
    if (value instanceof ObjectList list) {
      return index < list.length() ? read(list.objectAt(index), done) : Double.NaN;
    }
    if (value instanceof StructValue struct) {
      return index < struct.length() ? read(struct.memberAt(index), done) : Double.NaN;
    }
    return value instanceof MatrixValue matrix && index < matrix.rows()
        ? inRow(matrix, index, done)
        : Double.NaN;
  }

  private double inRow(MatrixValue matrix, int row, int done) {
    return done + 1 == steps.length
            && steps[done] instanceof VariablePath.Selector.Element column
            && column.index() < matrix.columns()
        ? matrix.numberAt(row, column.index())
        : Double.NaN;
  }

  private double member(Value value, String name, int done) {
    if (value instanceof StructValue struct) {
      List<String> names = struct.names();
      int index = names.indexOf(name);
      return index >= 0 ? read(struct.memberAt(index), done) : Double.NaN;
    }
    return Double.NaN;
  }
}
