package org.pendant.protocols.http;

import static org.pendant.protocols.http.HttpTexts.text;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/** HTTP framing: cuts what one peer sends into requests with a body of known length. */
final class HttpCutter {
  /** Most bytes of a head. */
  static final int MAX_HEAD = 8192;

  private static final String LENGTH = "content-length";

  private final ByteArrayOutputStream head = new ByteArrayOutputStream();
  private final Limits limits;
  private Optional<Head> known = Optional.empty();

  /** What is kept of the body; grows with what comes, as a length is told easily. */
  private ByteBuffer body = ByteBuffer.allocate(0);

  /** How much of the body has not come yet. */
  private int missing;

  /** Whether the peer holds the body back until it is told to continue. */
  private boolean heldBack;

  /** Where the body has taken a place. */
  private Optional<LargeBodies> place = Optional.empty();

  /** What is allowed. */
  @FunctionalInterface
  interface Limits {
    /** How large the body of a request may be. */
    BodyLimit of(String method, String path);
  }

  private record Head(
      String method,
      String path,
      Map<String, String> headers,
      boolean keep,
      Optional<HttpStatus> notKept) {}

  HttpCutter(Limits limits) {
    this.limits = limits;
  }

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
    Head read = known.get();
    int count = Math.min(bytes.remaining(), missing);
    missing -= count;
    if (read.notKept().isEmpty()) {
      makeRoom(count);
      body.put(bytes.slice(bytes.position(), count));
    }
    bytes.position(bytes.position() + count);
    if (missing > 0) {
      return Optional.empty();
    }
    known = Optional.empty();
    return Optional.of(
        new HttpCall(
            read.method(), read.path(), read.headers(), read.keep(), body.flip(), read.notKept()));
  }

  private void makeRoom(int count) {
    if (body.remaining() < count) {
      int whole = body.position() + count + missing;
      int wanted = Math.max(2 * body.capacity(), body.position() + count);
      body = ByteBuffer.allocate(Math.min(whole, wanted)).put(body.flip());
    }
  }

  /**
   * Whether the peer has to be told now that its body is welcome (RFC 9110, 10.1.1); true once. One
   * whose body is not kept is not told: it may see the refusal before it sends.
   */
  boolean tellToGoOn() {
    boolean tell = heldBack && missing > 0 && known.filter(h -> h.notKept().isEmpty()).isPresent();
    heldBack = false;
    return tell;
  }

  /** The newest request is done with; its body is not kept any more. */
  void forget() {
    body = ByteBuffer.allocate(0);
    place.ifPresent(LargeBodies::give);
    place = Optional.empty();
  }

  private void takeOfHead(byte next) throws ProtocolException {
    if (head.size() == MAX_HEAD) {
      throw new ProtocolException(text("headTooLong", MAX_HEAD));
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
      throw new ProtocolException(text("noHttpRequest"));
    }
    Map<String, String> headers = new HashMap<>();
    for (int i = 1; i < lines.length; i++) {
      int colon = lines[i].indexOf(':');
      if (colon < 1) {
        throw new ProtocolException(text("headNotHttp"));
      }
      headers.put(
          lines[i].substring(0, colon).toLowerCase(Locale.ROOT),
          lines[i].substring(colon + 1).strip());
    }
    String connection = headers.getOrDefault("connection", "").toLowerCase(Locale.ROOT);
    boolean keep =
        lines[0].endsWith("1.1") ? !connection.equals("close") : connection.equals("keep-alive");
    if (headers.containsKey("transfer-encoding")) {
      throw new ProtocolException(text("requestInChunks"));
    }
    int blank = lines[0].indexOf(' ');
    String target = lines[0].substring(blank + 1, lines[0].lastIndexOf(' '));
    int query = target.indexOf('?');
    String path = query < 0 ? target : target.substring(0, query);
    String method = lines[0].substring(0, blank);
    BodyLimit limit = limits.of(method, path);
    missing = length(headers.getOrDefault(LENGTH, "0"), limit.readBytes());
    known = Optional.of(new Head(method, path, headers, keep, notKept(limit)));
    heldBack =
        lines[0].endsWith("1.1")
            && headers.getOrDefault("expect", "").equalsIgnoreCase("100-continue");
    body = ByteBuffer.allocate(0);
  }

  /** Why a body is not kept that is about to come. */
  private Optional<HttpStatus> notKept(BodyLimit limit) {
    if (missing > limit.keptBytes()) {
      return Optional.of(HttpStatus.TOO_LARGE);
    }
    if (missing <= BodyLimit.USUAL_BYTES) {
      return Optional.empty();
    }
    place = limit.room().filter(LargeBodies::take);
    return place.isPresent() ? Optional.empty() : Optional.of(HttpStatus.UNAVAILABLE);
  }

  private static int length(String text, int most) throws ProtocolException {
    if (!text.matches("[0-9]{1,9}") || Integer.parseInt(text) > most) {
      throw new ProtocolException(text("wrongContentLength", text, most));
    }
    return Integer.parseInt(text);
  }
}
