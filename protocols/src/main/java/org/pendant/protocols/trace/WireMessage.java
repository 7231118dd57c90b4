package org.pendant.protocols.trace;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Set;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/**
 * Wire message: one message of a client or to it.
 *
 * @param number counts the messages of a trace, from 1
 * @param epochUs when its last byte came or went, us since 1970
 * @param robotTimeS the same by the robot, s
 * @param reading what it says
 * @param bytes read-only
 */
public record WireMessage(
    long number,
    Peers peers,
    Direction direction,
    long epochUs,
    double robotTimeS,
    Reading reading,
    ByteBuffer bytes) {
  private static final Set<String> STREAMS =
      Set.of("data", "robot-state", "variable-values", "modbus-info");

  /**
   * Its parts by their names; what is wrong where they cannot be read, as peers send what they
   * like.
   */
  public Map<String, ?> fields() {
    try {
      return reading.fields().get();
    } catch (RuntimeException e) {
      return Fields.of("unreadable", String.valueOf(e.getMessage()));
    }
  }

  /** Whether it is one of the many that come by themselves, at a rate. */
  public boolean streamed() {
    return direction == Direction.OUT && STREAMS.contains(reading.type());
  }
}
