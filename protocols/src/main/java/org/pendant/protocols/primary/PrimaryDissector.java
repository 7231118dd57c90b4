package org.pendant.protocols.primary;

import static org.pendant.protocols.primary.PrimaryTexts.text;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.protocols.script.ScriptDissector;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** Primary dissector: what goes over the primary and secondary ports. */
final class PrimaryDissector implements Dissector {
  private static final int HEADER_BYTES = 5;
  private static final int ROBOT_STATE = 16;
  private static final int ROBOT_MESSAGE = 20;
  private static final int VARIABLES = 25;
  private static final int MODBUS_INFO = 5;

  private final ScriptDissector scripts;

  /** Names of the program's variables, by their places. */
  private final Map<Integer, String> variables = new HashMap<>();

  /** Of a port that runs what it is sent, or of a read-only one. */
  PrimaryDissector(boolean obeyed) {
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
    int size = bytes.getInt(bytes.position());
    return size < HEADER_BYTES ? UNKNOWN : size;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    if (direction == Direction.IN) {
      return scripts.read(direction, message);
    }
    int type = message.get(HEADER_BYTES - 1);
    ByteBuffer body = message.position(HEADER_BYTES).slice();
    return switch (type) {
      case ROBOT_STATE -> RobotStateReading.of(body);
      case ROBOT_MESSAGE -> RobotMessageReading.of(body);
      case VARIABLES -> variables(body);
      case MODBUS_INFO -> Reading.of("modbus-info", text("stateOfModbusSignals"));
      default -> Reading.of("package", text("packageOfType", type));
    };
  }

  private Reading variables(ByteBuffer body) {
    long timeUs = body.getLong();
    boolean names = body.get() == 0;
    int first = Short.toUnsignedInt(body.getShort());
    if (names) {
      List<String> texts = Dissector.text(body).lines().toList();
      for (int i = 0; i < texts.size(); i++) {
        variables.put(first + i, texts.get(i));
      }
      return Reading.of(
          "variable-names",
          texts.isEmpty() ? text("noVariables") : text("variables", Reading.names(texts)),
          () -> Fields.of("time_us", timeUs, "names", texts));
    }
    Map<String, Object> values = values(first, body);
    List<String> shown = new ArrayList<>();
    values.forEach((name, value) -> shown.add(name + " = " + value));
    return Reading.of(
        "variable-values",
        shown.isEmpty() ? text("noVariableChanged") : Reading.names(shown),
        () -> Fields.of("time_us", timeUs, "values", values));
  }

  private Map<String, Object> values(int first, ByteBuffer body) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int place = first; body.hasRemaining(); place++) {
      Object value = SentValue.read(body);
      body.get(); // the line end after each
      values.put(variables.getOrDefault(place, "variable " + place), value);
    }
    return values;
  }
}
