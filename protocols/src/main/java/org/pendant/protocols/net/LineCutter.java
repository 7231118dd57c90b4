package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Line framing: cuts what one peer sends into lines. A line ends with a line feed, before which a
 * carriage return does not count.
 */
public final class LineCutter {
  private final int longest;
  private final ByteArrayOutputStream begun = new ByteArrayOutputStream();

  /**
   * Begins with an empty line.
   *
   * @param longest most bytes of a line, its end not counted
   */
  public LineCutter(int longest) {
    this.longest = longest;
  }

  /**
   * Takes bytes, cut anywhere.
   *
   * @return the lines that they complete, one {@code char} a byte, without their ends
   * @throws ProtocolException if a line becomes too long
   */
  public List<String> take(ByteBuffer bytes) throws ProtocolException {
    List<String> lines = new ArrayList<>();
    while (bytes.hasRemaining()) {
      byte next = bytes.get();
      if (next == '\n') {
        lines.add(line());
      } else if (begun.size() < longest) {
        begun.write(next);
      } else {
        throw new ProtocolException(text("lineTooLong", longest));
      }
    }
    return lines;
  }

  private String line() {
    String line = begun.toString(StandardCharsets.ISO_8859_1);
    begun.reset();
    return line.endsWith("\r") ? line.substring(0, line.length() - 1) : line;
  }
}
