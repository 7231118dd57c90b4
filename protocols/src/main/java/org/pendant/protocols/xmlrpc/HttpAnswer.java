package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** HTTP answer: reads one, of whatever server. */
final class HttpAnswer {
  private static final int MAX_LINE = 8192;
  private static final int MAX_HEADERS = 100;
  private static final int OK = 200;

  private final ByteArrayOutputStream body = new ByteArrayOutputStream();
  private final Bytes in;
  private String version = "";
  private Map<String, String> headers = Map.of();
  private boolean lengthKnown;

  /** Where the bytes come from. */
  interface Bytes {
    /** The next one, or -1 at the end. */
    int read() throws IOException;
  }

  private HttpAnswer(Bytes in) {
    this.in = in;
  }

  /**
   * Reads an answer to its end.
   *
   * @throws IOException when it is none, too long, or not one of success; the message says why
   */
  static HttpAnswer read(Bytes in) throws IOException {
    HttpAnswer answer = new HttpAnswer(in);
    answer.readHead();
    answer.readBody();
    return answer;
  }

  byte[] body() {
    return body.toByteArray();
  }

  /** Whether another call may go by the same connection. */
  boolean keepsConnection() {
    String connection = header("connection");
    return lengthKnown
        && (version.equals("HTTP/1.1")
            ? !connection.contains("close")
            : connection.contains("keep-alive"));
  }

  private String header(String name) {
    return headers.getOrDefault(name, "").toLowerCase(Locale.ROOT);
  }

  private void readHead() throws IOException {
    int status;
    String statusLine;
    do {
      statusLine = readLine();
      if (!statusLine.matches("HTTP/1\\.[01] [0-9]{3}( .*)?")) {
        throw new IOException(text("answerNotHttp"));
      }
      version = statusLine.substring(0, "HTTP/1.1".length());
      status = Integer.parseInt(statusLine.substring(version.length() + 1, version.length() + 4));
      headers = readHeaders();
      // 100 to 199 only announce the answer
    } while (status < OK);
    if (status != OK) {
      throw new IOException(text("httpStatus", statusLine.substring(version.length() + 1).strip()));
    }
  }

  private Map<String, String> readHeaders() throws IOException {
    Map<String, String> read = new HashMap<>();
    for (String line = readLine(); !line.isEmpty(); line = readLine()) {
      int colon = line.indexOf(':');
      if (colon < 1 || read.size() == MAX_HEADERS) {
        throw new IOException(text("answerHeadNotHttp"));
      }
      read.put(
          line.substring(0, colon).toLowerCase(Locale.ROOT), line.substring(colon + 1).strip());
    }
    return read;
  }

  private String readLine() throws IOException {
    StringBuilder line = new StringBuilder();
    for (int next = RpcConnection.orEnd(in.read());
        next != '\n';
        next = RpcConnection.orEnd(in.read())) {
      if (line.length() == MAX_LINE) {
        throw new IOException(text("answerLineTooLong", MAX_LINE));
      }
      line.append((char) next);
    }
    if (!line.isEmpty() && line.charAt(line.length() - 1) == '\r') {
      line.setLength(line.length() - 1);
    }
    return line.toString();
  }

  private void readBody() throws IOException {
    if (header("transfer-encoding").contains("chunked")) {
      lengthKnown = true;
      readChunks();
    } else if (headers.containsKey("content-length")) {
      lengthKnown = true;
      readExactly(number(header("content-length"), 10));
    } else {
      for (int next = in.read(); next >= 0; next = in.read()) {
        RpcConnection.bound(body.size() + 1L);
        body.write(next);
      }
    }
  }

  private void readChunks() throws IOException {
    while (true) {
      String size = readLine();
      int extension = size.indexOf(';');
      long count = number((extension < 0 ? size : size.substring(0, extension)).strip(), 16);
      if (count == 0) {
        readHeaders();
        return;
      }
      readExactly(count);
      if (!readLine().isEmpty()) {
        throw new IOException(text("chunkEndsWrongly"));
      }
    }
  }

  private void readExactly(long count) throws IOException {
    RpcConnection.bound(body.size() + count);
    for (long i = 0; i < count; i++) {
      body.write(RpcConnection.orEnd(in.read()));
    }
  }

  private static long number(String text, int radix) throws IOException {
    if (!text.matches("[0-9A-Fa-f]{1,10}")) {
      throw new IOException(text("answerLengthNoNumber", text));
    }
    try {
      return Long.parseLong(text, radix);
    } catch (NumberFormatException e) {
      throw new IOException(text("answerLengthNoNumber", text), e);
    }
  }
}
