package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;
import org.pendant.protocols.wire.Dissector;

/** Sent value: what {@link ValueCodec} has written, as numbers, truth values, texts and lists. */
final class SentValue {
  private SentValue() {}

  /** Takes a value at the buffer's position. */
  static Object read(ByteBuffer in) {
    byte type = in.get();
    return switch (type) {
      case ValueCodec.NONE -> "none";
      case ValueCodec.VAR_STRING -> {
        int length = in.getShort();
        String text = Dissector.text(in.slice(in.position(), length));
        in.position(in.position() + length);
        yield text;
      }
      case ValueCodec.POSE -> {
        List<Double> numbers = new ArrayList<>();
        for (int i = 0; i < Pose.SIZE; i++) {
          numbers.add((double) in.getFloat());
        }
        yield numbers;
      }
      case ValueCodec.BOOL -> in.get() != 0;
      case ValueCodec.INT -> in.getInt();
      case ValueCodec.FLOAT -> (double) in.getFloat();
      case ValueCodec.LIST -> list(in, in.getShort());
      case ValueCodec.MATRIX -> {
        int rows = in.getShort();
        int columns = in.getShort();
        List<Object> matrix = new ArrayList<>();
        for (int i = 0; i < rows; i++) {
          matrix.add(list(in, columns));
        }
        yield matrix;
      }
      default -> throw new IllegalArgumentException("a value has type " + type);
    };
  }

  private static List<Object> list(ByteBuffer in, int count) {
    List<Object> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      items.add(read(in));
    }
    return items;
  }
}
