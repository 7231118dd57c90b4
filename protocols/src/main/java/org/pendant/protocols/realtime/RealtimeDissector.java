package org.pendant.protocols.realtime;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.protocols.script.ScriptDissector;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Reading;

/** Real-time dissector: packages of numbers, and the scripts that clients send. */
final class RealtimeDissector implements Dissector {
  private final ScriptDissector scripts;

  /** Of a port that runs what it is sent, or of a read-only one. */
  RealtimeDissector(boolean obeyed) {
    scripts = new ScriptDissector(obeyed);
  }

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    if (direction == Direction.IN) {
      return scripts.length(direction, bytes);
    }
    if (bytes.remaining() < Integer.BYTES) {
      return MORE;
    }
    return bytes.getInt(bytes.position()) == RealtimeCodec.BYTES ? RealtimeCodec.BYTES : UNKNOWN;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    return direction == Direction.IN
        ? scripts.read(direction, message)
        : Reading.of(
            "data",
            "timestamp = " + message.getDouble(message.position() + Integer.BYTES),
            () -> fields(message.duplicate()));
  }

  private static Map<String, Object> fields(ByteBuffer in) {
    Map<String, Object> fields = new LinkedHashMap<>();
    in.getInt();
    for (RealtimeCodec.Part part : RealtimeCodec.PARTS) {
      switch (part) {
        case RealtimeCodec.Quantity quantity -> {
          int size = StateQuantities.of(quantity.name()).size();
          List<Double> numbers = new ArrayList<>();
          for (int i = 0; i < size; i++) {
            numbers.add(in.getDouble());
          }
          fields.put(quantity.name(), size == 1 ? numbers.getFirst() : numbers);
        }
        case RealtimeCodec.Reserved reserved ->
            in.position(in.position() + reserved.count() * Double.BYTES);
      }
    }
    return fields;
  }
}
