package org.pendant.protocols.http;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Form data: what a form sends, {@code multipart/form-data} (RFC 7578). */
public final class FormData {
  /** More parts than any form that is understood here has. */
  private static final int MAX_PARTS = 16;

  private static final int MAX_HEAD = 4096;

  private static final Pattern TYPE =
      Pattern.compile(
          "(?i)multipart/form-data\\s*;(?:.*;)?\\s*boundary=(?:\"([^\"]{1,70})\"|([^\";\\s]{1,70}))"
              + "\\s*(?:;.*)?");

  private static final Pattern NAME =
      Pattern.compile(
          "(?im)^content-disposition:\\s*form-data\\s*;(?:.*;)?\\s*name=(?:\"([^\"]*)\"|([^\";\\s]*))");

  private final byte[] body;
  private final byte[] delimiter;

  private FormData(byte[] body, String boundary) {
    this.body = body;
    delimiter = ("--" + boundary).getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * The content of a field.
   *
   * @param type the {@code Content-Type} of the request
   * @return empty if this is no form, or one without that field
   */
  public static Optional<byte[]> field(String type, byte[] body, String name) {
    Matcher form = TYPE.matcher(type);
    if (!form.matches()) {
      return Optional.empty();
    }
    return new FormData(body, form.group(1) == null ? form.group(2) : form.group(1)).field(name);
  }

  private Optional<byte[]> field(String name) {
    int at = startsWith(0, delimiter) ? delimiter.length : -1;
    for (int part = 0; at >= 0 && part < MAX_PARTS; part++) {
      int head = afterLine(at);
      int end = head < 0 ? -1 : nextDelimiter(head);
      int content = end < 0 ? -1 : afterHead(head, end);
      if (content < 0) {
        return Optional.empty();
      }
      // the head keeps the end of its last line
      String lines =
          new String(body, head, Math.min(content - head, MAX_HEAD), StandardCharsets.UTF_8);
      Matcher named = NAME.matcher(lines);
      if (named.find() && name.equals(named.group(1) == null ? named.group(2) : named.group(1))) {
        return Optional.of(Arrays.copyOfRange(body, content, end));
      }
      at = end + 2 + delimiter.length;
    }
    return Optional.empty();
  }

  private boolean startsWith(int at, byte[] wanted) {
    return at + wanted.length <= body.length
        && Arrays.equals(body, at, at + wanted.length, wanted, 0, wanted.length);
  }

  private boolean lineEnds(int at) {
    return at + 1 < body.length && body[at] == '\r' && body[at + 1] == '\n';
  }

  /** After the rest of a delimiter's line, which is blank; -1 after the last delimiter. */
  private int afterLine(int at) {
    int end = at;
    while (end < body.length && (body[end] == ' ' || body[end] == '\t')) {
      end++;
    }
    return lineEnds(end) ? end + 2 : -1;
  }

  /** Where the line end before the next delimiter is; -1 if there is none. */
  private int nextDelimiter(int from) {
    for (int i = from; i < body.length; i++) {
      if (lineEnds(i) && startsWith(i + 2, delimiter)) {
        return i;
      }
    }
    return -1;
  }

  /** Behind the blank line that ends the head of a part; -1 if there is none. */
  private int afterHead(int from, int end) {
    for (int i = from; i + 2 <= end && i - from < MAX_HEAD; i++) {
      if (lineEnds(i) && lineEnds(i + 2)) {
        return Math.min(i + 4, end);
      }
    }
    return -1;
  }
}
