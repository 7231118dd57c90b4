package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Value decoder: what {@link ValueCodec} has written, and real robots, as script values. Numbers
 * have come as {@code float}: they become the shortest decimal number that is the same one there,
 * so that 0.1 is 0.1 again.
 */
final class ValueDecoder {
  private static final byte CONST_STRING = 3;
  private static final byte NUM = 14;

  private ValueDecoder() {}

  /**
   * Takes a value at the buffer's position; empty where a variable has none.
   *
   * @throws RuntimeException if it is cut off, or has an unknown type
   */
  static Optional<Value> decode(ByteBuffer in) {
    byte type = in.get();
    return type == ValueCodec.NONE ? Optional.empty() : Optional.of(value(type, in));
  }

  private static Value value(byte type, ByteBuffer in) {
    return switch (type) {
      case CONST_STRING, ValueCodec.VAR_STRING -> {
        byte[] bytes = new byte[Short.toUnsignedInt(in.getShort())];
        in.get(bytes);
        yield Value.of(new String(bytes, StandardCharsets.ISO_8859_1));
      }
      case ValueCodec.POSE -> {
        double[] numbers = new double[Pose.SIZE];
        for (int i = 0; i < numbers.length; i++) {
          numbers[i] = number(in);
        }
        yield new PoseValue(
            new Pose(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]));
      }
      case ValueCodec.BOOL -> Value.of(in.get() != 0);
      case ValueCodec.INT -> Value.of(in.getInt());
      case NUM, ValueCodec.FLOAT -> Value.of(number(in));
      case ValueCodec.LIST -> list(in);
      case ValueCodec.MATRIX -> matrix(in);
      default -> throw new IllegalArgumentException("a value has type " + type);
    };
  }

  private static double number(ByteBuffer in) {
    return Double.parseDouble(Float.toString(in.getFloat()));
  }

  private static Value list(ByteBuffer in) {
    int count = Short.toUnsignedInt(in.getShort());
    if (count == 0) {
      return NumberList.of();
    }
    byte type = in.get(in.position());
    if (type != ValueCodec.BOOL && !isNumber(type)) {
      Value[] elements = new Value[count];
      for (int i = 0; i < count; i++) {
        elements[i] = value(in.get(), in);
      }
      return ObjectList.owning(elements, count, elements[0]);
    }
    double[] numbers = new double[count];
    boolean integers = numbers(in, numbers);
    ValueKind kind = integers ? ValueKind.INT : ValueKind.FLOAT;
    return NumberList.owning(numbers, count, type == ValueCodec.BOOL ? ValueKind.BOOL : kind);
  }

  private static Value matrix(ByteBuffer in) {
    int rows = Short.toUnsignedInt(in.getShort());
    int columns = Short.toUnsignedInt(in.getShort());
    if ((long) rows * columns > in.remaining()) {
      throw new IllegalArgumentException("a matrix is cut off");
    }
    double[] numbers = new double[rows * columns];
    boolean integers = numbers(in, numbers);
    return MatrixValue.owning(rows, columns, numbers, integers);
  }

  private static boolean isNumber(byte type) {
    return type == ValueCodec.INT || type == ValueCodec.FLOAT || type == NUM;
  }

  /** Fills an array; answers whether all of them are whole numbers. */
  private static boolean numbers(ByteBuffer in, double[] numbers) {
    boolean integers = true;
    for (int i = 0; i < numbers.length; i++) {
      byte type = in.get();
      integers &= type == ValueCodec.INT;
      if (type == ValueCodec.BOOL) {
        numbers[i] = in.get();
      } else if (type == ValueCodec.INT) {
        numbers[i] = in.getInt();
      } else if (isNumber(type)) {
        numbers[i] = number(in);
      } else {
        throw new IllegalArgumentException("a number has type " + type);
      }
    }
    return integers;
  }
}
