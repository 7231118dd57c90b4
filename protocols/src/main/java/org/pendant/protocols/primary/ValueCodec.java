package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Value codec: script values as bytes, as since version 5.9: a type, then the value. Structs and
 * handles have no type of their own there: they go as text.
 */
final class ValueCodec {
  static final byte NONE = 0;
  static final byte VAR_STRING = 4;
  static final byte POSE = 12;
  static final byte BOOL = 13;
  static final byte INT = 15;
  static final byte FLOAT = 16;
  static final byte LIST = 17;
  static final byte MATRIX = 18;

  private static final int NUMBER_BYTES = 5;

  /** Bytes of a text, and elements of a list, that a 16-bit length can count. */
  private static final int MOST = Short.MAX_VALUE;

  private ValueCodec() {}

  /** No value. */
  static byte[] none() {
    return new byte[] {NONE};
  }

  static byte[] encode(Value value) {
    ByteBuffer out = ByteBuffer.allocate(size(value));
    put(value, out);
    return out.array();
  }

  private static int size(Value value) {
    return switch (value) {
      case NoneValue none -> 1;
      case BoolValue bool -> 2;
      case IntValue number -> NUMBER_BYTES;
      case FloatValue number -> NUMBER_BYTES;
      case StringValue string -> textSize(string.text());
      case StructValue struct -> textSize(struct.text());
      case HandleValue handle -> textSize(handle.text());
      case PoseValue pose -> 1 + Pose.SIZE * Float.BYTES;
      case NumberList list ->
          3 + count(list) * (list.elementKind() == ValueKind.BOOL ? 2 : NUMBER_BYTES);
      case ObjectList list -> {
        int size = 3;
        for (int i = 0; i < count(list); i++) {
          size += size(list.objectAt(i));
        }
        yield size;
      }
      case MatrixValue matrix -> 5 + matrix.rows() * matrix.columns() * NUMBER_BYTES;
    };
  }

  private static int textSize(String text) {
    return 3 + Math.min(text.length(), MOST);
  }

  private static int count(ListValue list) {
    return Math.min(list.length(), MOST);
  }

  private static void put(Value value, ByteBuffer out) {
    switch (value) {
      case NoneValue none -> out.put(NONE);
      case BoolValue bool -> out.put(BOOL).put((byte) (bool.value() ? 1 : 0));
      case IntValue number -> out.put(INT).putInt(number.value());
      case FloatValue number -> out.put(FLOAT).putFloat((float) number.value());
      case StringValue string -> putText(string.text(), out);
      case StructValue struct -> putText(struct.text(), out);
      case HandleValue handle -> putText(handle.text(), out);
      case PoseValue pose -> {
        out.put(POSE);
        for (int i = 0; i < Pose.SIZE; i++) {
          out.putFloat((float) pose.pose().get(i));
        }
      }
      case NumberList list -> {
        out.put(LIST).putShort((short) count(list));
        for (int i = 0; i < count(list); i++) {
          putNumber(list.elementKind(), list.numberAt(i), out);
        }
      }
      case ObjectList list -> {
        out.put(LIST).putShort((short) count(list));
        for (int i = 0; i < count(list); i++) {
          put(list.objectAt(i), out);
        }
      }
      case MatrixValue matrix -> {
        out.put(MATRIX).putShort((short) matrix.rows()).putShort((short) matrix.columns());
        for (int i = 0; i < matrix.rows() * matrix.columns(); i++) {
          putNumber(matrix.elementKind(), matrix.numberAt(i), out);
        }
      }
    }
  }

  private static void putNumber(ValueKind kind, double number, ByteBuffer out) {
    switch (kind) {
      case BOOL -> out.put(BOOL).put((byte) (number != 0 ? 1 : 0));
      case INT -> out.put(INT).putInt((int) number);
      default -> out.put(FLOAT).putFloat((float) number);
    }
  }

  private static void putText(String text, ByteBuffer out) {
    String sent = text.length() > MOST ? text.substring(0, MOST) : text;
    out.put(VAR_STRING)
        .putShort((short) sent.length())
        .put(sent.getBytes(StandardCharsets.ISO_8859_1));
  }
}
