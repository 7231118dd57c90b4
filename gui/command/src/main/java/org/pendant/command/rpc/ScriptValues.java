package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/** Script values as values of an answer: poses as six numbers, matrices as rows. */
final class ScriptValues {
  /** Numbers and texts in one answer at most. */
  static final int MAX_ELEMENTS = 200_000;

  private int elements;

  /** What an answer says of {@code value}. */
  Object of(Value value) throws RpcFailure {
    return switch (value) {
      case NoneValue _ -> counted(Optional.empty());
      case BoolValue bool -> counted(bool.value());
      case IntValue number -> counted(number.value());
      case FloatValue number -> counted(number.value());
      case StringValue text -> counted(ByteText.decoded(text.bytes()));
      case HandleValue handle -> counted(ByteText.decoded(handle.text()));
      case PoseValue pose -> numbers(pose.pose().toArray());
      case ListValue list -> list(list);
      case MatrixValue matrix -> matrix(matrix);
      case StructValue struct -> struct(struct);
    };
  }

  private Object counted(Object element) throws RpcFailure {
    elements++;
    if (elements > MAX_ELEMENTS) {
      throw new RpcFailure(RpcFailure.TOO_MUCH, text("tooManyElements", MAX_ELEMENTS));
    }
    return element;
  }

  private List<Object> numbers(double... numbers) throws RpcFailure {
    List<Object> list = new ArrayList<>();
    for (double each : numbers) {
      list.add(counted(each));
    }
    return list;
  }

  private List<Object> list(ListValue list) throws RpcFailure {
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < list.length(); i++) {
      try {
        values.add(of(list.get(i)));
      } catch (ScriptError e) {
        throw new IllegalStateException("a list without its element " + i, e);
      }
    }
    return values;
  }

  private List<Object> matrix(MatrixValue matrix) throws RpcFailure {
    List<Object> rows = new ArrayList<>();
    for (int row = 0; row < matrix.rows(); row++) {
      List<Object> cells = new ArrayList<>();
      for (int column = 0; column < matrix.columns(); column++) {
        double number = matrix.numberAt(row, column);
        cells.add(matrix.integers() ? counted((long) number) : counted(number));
      }
      rows.add(cells);
    }
    return rows;
  }

  private Map<String, Object> struct(StructValue struct) throws RpcFailure {
    Map<String, Object> members = new LinkedHashMap<>();
    for (int i = 0; i < struct.length(); i++) {
      members.put(ByteText.decoded(struct.names().get(i)), of(struct.memberAt(i)));
    }
    return members;
  }
}
