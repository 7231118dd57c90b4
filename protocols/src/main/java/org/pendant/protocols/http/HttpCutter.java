package org.pendant.protocols.http;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/** Cuts what one peer sends into requests of HTTP with a body of known length. */
final class HttpCutter {
  /** Most bytes of a head. */
  static final int LONGEST_HEAD = 8192;

  /** Most bytes of a body; a request has a few hundred. */
  static final int LONGEST_BODY = 65_536;

  private static final String LENGTH = "content-length";

  private final ByteArrayOutputStream head = new ByteArrayOutputStream();
  private Optional<Head> known = Optional.empty();
  private ByteBuffer body = ByteBuffer.allocate(0);

  private record Head(String method, String path, Map<String, String> headers, boolean keep) {}

  /**
   * Takes bytes, cut anywhere, up to the end of a request.
   *
   * @return the request that they complete; empty when all are taken and more are needed
   * @throws ProtocolException if they are no request, or one that is too long
   */
  Optional<HttpCall> next(ByteBuffer bytes) throws ProtocolException {
    while (known.isEmpty()) {
      if (!bytes.hasRemaining()) {
        return Optional.empty();
      }
      takeOfHead(bytes.get());
    }
    int count = Math.min(bytes.remaining(), body.remaining());
    body.put(bytes.slice(bytes.position(), count));
    bytes.position(bytes.position() + count);
    if (body.hasRemaining()) {
      return Optional.empty();
    }
    Head read = known.get();
    HttpCall call =
        new HttpCall(read.method(), read.path(), read.headers(), read.keep(), body.flip());
    known = Optional.empty();
    return Optional.of(call);
  }

  private void takeOfHead(byte next) throws ProtocolException {
    if (head.size() == LONGEST_HEAD) {
      throw new ProtocolException("the head of a request has more than " + LONGEST_HEAD + " bytes");
    }
    head.write(next);
    if (next != '\n') {
      return;
    }
    String text = head.toString(StandardCharsets.ISO_8859_1).replace("\r\n", "\n");
    if (text.endsWith("\n\n")) {
      head.reset();
      begin(text.split("\n"));
    }
  }

  private void begin(String... lines) throws ProtocolException {
    if (lines.length == 0 || !lines[0].matches("[A-Z]{1,16} [^ ]+ HTTP/1\\.[01]")) {
      throw new ProtocolException("no request of HTTP");
    }
    Map<String, String> headers = new HashMap<>();
    for (int i = 1; i < lines.length; i++) {
      int colon = lines[i].indexOf(':');
      if (colon < 1) {
        throw new ProtocolException("the head of a request is not HTTP");
      }
      headers.put(
          lines[i].substring(0, colon).toLowerCase(Locale.ROOT),
          lines[i].substring(colon + 1).strip().toLowerCase(Locale.ROOT));
    }
    String connection = headers.getOrDefault("connection", "");
    boolean keep =
        lines[0].endsWith("1.1") ? !connection.equals("close") : connection.equals("keep-alive");
    if (headers.containsKey("transfer-encoding")) {
      throw new ProtocolException("a request in chunks, must have a Content-Length");
    }
    body = ByteBuffer.allocate(length(headers.getOrDefault(LENGTH, "0")));
    int blank = lines[0].indexOf(' ');
    String target = lines[0].substring(blank + 1, lines[0].lastIndexOf(' '));
    int query = target.indexOf('?');
    String path = query < 0 ? target : target.substring(0, query);
    known = Optional.of(new Head(lines[0].substring(0, blank), path, headers, keep));
  }

  private static int length(String text) throws ProtocolException {
    if (!text.matches("[0-9]{1,9}") || Integer.parseInt(text) > LONGEST_BODY) {
      throw new ProtocolException(
          "the Content-Length is " + text + ", must be 0 to " + LONGEST_BODY);
    }
    return Integer.parseInt(text);
  }
}
