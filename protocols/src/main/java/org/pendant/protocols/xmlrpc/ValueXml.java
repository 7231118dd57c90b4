package org.pendant.protocols.xmlrpc;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.language.source.ByteText;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Operators;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Value conversion: values of scripts as the types of XML-RPC and back: lists and matrices are
 * arrays, and a pose is a struct of x, y, z (m), rx, ry, rz (rad), as the real controller has it.
 */
final class ValueXml {
  private static final List<String> POSE = List.of("x", "y", "z", "rx", "ry", "rz");

  private ValueXml() {}

  /**
   * What the library writes for a value.
   *
   * @throws ScriptError when XML-RPC has no type for it
   */
  static Object toXml(Value value) throws ScriptError {
    return switch (value) {
      case BoolValue bool -> bool.value();
      case IntValue number -> number.value();
      case FloatValue number -> number(number.value());
      case StringValue text -> text(text.bytes());
      case PoseValue pose -> pose(pose.pose());
      case ListValue list -> array(list);
      case MatrixValue matrix -> array(matrix);
      case StructValue struct -> struct(struct);
      case NoneValue none -> throw refused(XmlRpcTexts.text("noneCannotBeSent"));
      case HandleValue handle ->
          throw refused(XmlRpcTexts.text("handleCannotBeSent", handle.type().text()));
    };
  }

  private static Double number(double number) throws ScriptError {
    if (!Double.isFinite(number)) {
      throw refused(XmlRpcTexts.text("notFinite", number));
    }
    return number;
  }

  private static String text(String bytes) throws ScriptError {
    String text = ByteText.decoded(bytes);
    for (int i = 0; i < text.length(); i++) {
      char next = text.charAt(i);
      if (next < ' ' && next != '\t' && next != '\n' && next != '\r') {
        throw refused(XmlRpcTexts.text("textWithControlByte", (int) next));
      }
    }
    return text;
  }

  private static Map<String, Object> pose(Pose pose) throws ScriptError {
    Map<String, Object> members = new LinkedHashMap<>();
    for (int i = 0; i < POSE.size(); i++) {
      members.put(POSE.get(i), number(pose.get(i)));
    }
    return members;
  }

  private static List<Object> array(ListValue list) throws ScriptError {
    List<Object> elements = new ArrayList<>(list.length());
    for (int i = 0; i < list.length(); i++) {
      elements.add(toXml(list.get(i)));
    }
    return elements;
  }

  private static List<Object> array(MatrixValue matrix) throws ScriptError {
    List<Object> rows = new ArrayList<>(matrix.rows());
    for (int i = 0; i < matrix.rows(); i++) {
      rows.add(array(matrix.row(i)));
    }
    return rows;
  }

  private static Map<String, Object> struct(StructValue struct) throws ScriptError {
    Map<String, Object> members = new LinkedHashMap<>();
    for (int i = 0; i < struct.length(); i++) {
      members.put(struct.names().get(i), toXml(struct.memberAt(i)));
    }
    return members;
  }

  /**
   * The value for what the library has read.
   *
   * @throws ScriptError when scripts have no value for it
   */
  static Value fromXml(Object read) throws ScriptError {
    return switch (read) {
      case null -> NoneValue.NONE;
      case Boolean bool -> Value.of((boolean) bool);
      case Integer number -> Value.of((int) number);
      case Long number -> integer(number);
      case Double number -> Value.of((double) number);
      case String text -> Value.of(ByteText.asBytes(text));
      case Object[] elements -> list(elements);
      case Map<?, ?> members -> struct(members);
      default ->
          throw new ScriptError("rpc-failed", XmlRpcTexts.text("answerOfForeignType", name(read)));
    };
  }

  private static String name(Object read) {
    return read instanceof byte[] ? "base64" : read.getClass().getSimpleName();
  }

  private static Value integer(long number) throws ScriptError {
    if (number != (int) number) {
      throw new ScriptError("rpc-failed", XmlRpcTexts.text("answerDoesNotFitInt", number));
    }
    return Value.of((int) number);
  }

  private static Value list(Object... elements) throws ScriptError {
    List<Value> values = new ArrayList<>(elements.length);
    for (Object element : elements) {
      values.add(fromXml(element));
    }
    return Operators.listLiteral(values);
  }

  private static Value struct(Map<?, ?> members) throws ScriptError {
    List<String> names = new ArrayList<>(members.size());
    List<Value> values = new ArrayList<>(members.size());
    for (Map.Entry<?, ?> member : members.entrySet()) {
      names.add(ByteText.asBytes((String) member.getKey()));
      values.add(fromXml(member.getValue()));
    }
    boolean pose =
        names.size() == POSE.size()
            && names.containsAll(POSE)
            && values.stream().allMatch(value -> value.kind().isNumber());
    if (pose) {
      double[] numbers = new double[POSE.size()];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = ((Number) members.get(POSE.get(i))).doubleValue();
      }
      return new PoseValue(
          new Pose(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]));
    }
    return StructValue.owning(names, values.toArray(new Value[0]));
  }

  private static ScriptError refused(String what) {
    return new ScriptError("wrong-type", what);
  }
}
