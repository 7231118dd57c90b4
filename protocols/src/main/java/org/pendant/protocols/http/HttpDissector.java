package org.pendant.protocols.http;

import java.nio.ByteBuffer;
import java.util.Locale;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** HTTP dissector: requests and answers with a body of known length, or of none. */
public final class HttpDissector implements Dissector {
  private static final String HEAD_END = "\r\n\r\n";
  private static final String LENGTH = "\r\ncontent-length:";

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    ByteBuffer first = bytes.slice(bytes.position(), Math.min(bytes.remaining(), 1 << 14));
    String text = Dissector.text(first);
    int end = text.indexOf(HEAD_END);
    if (end < 0) {
      return text.length() < HttpCutter.MAX_HEAD ? MORE : UNKNOWN;
    }
    String head = text.substring(0, end).toLowerCase(Locale.ROOT);
    int at = head.indexOf(LENGTH);
    if (at < 0) {
      return end + HEAD_END.length();
    }
    String number = head.substring(at + LENGTH.length()).lines().findFirst().orElse("").strip();
    return number.matches("\\d{1,8}")
        ? end + HEAD_END.length() + Integer.parseInt(number)
        : UNKNOWN;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    String text = Dissector.text(message);
    String line = text.lines().findFirst().orElse("");
    boolean asks = direction == Direction.IN;
    boolean changes = asks && !line.startsWith("GET ");
    Reading reading =
        Reading.quoting(asks ? "request" : "answer", line, () -> Fields.of("text", text));
    return changes ? reading.doing(line) : reading;
  }
}
