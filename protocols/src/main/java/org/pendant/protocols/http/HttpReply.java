package org.pendant.protocols.http;

import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * HTTP reply to a request.
 *
 * @param type of the body, such as {@code text/xml}
 * @param allowed the methods there are instead; empty unless the method was wrong
 */
public record HttpReply(HttpStatus status, String type, String body, List<String> allowed) {
  /** Copies the list. */
  public HttpReply {
    allowed = List.copyOf(allowed);
  }

  /** An answer to a method that there is. */
  public HttpReply(HttpStatus status, String type, String body) {
    this(status, type, body, List.of());
  }

  /**
   * As it is sent.
   *
   * @param keep whether the connection stays for another request
   */
  byte[] bytes(boolean keep) {
    byte[] content = body.getBytes(StandardCharsets.UTF_8);
    String head =
        "HTTP/1.1 "
            + status.code()
            + " "
            + status.reason()
            + "\r\n"
            + (allowed.isEmpty() ? "" : "Allow: " + String.join(", ", allowed) + "\r\n")
            + "Server: Pendant\r\nContent-Type: "
            + type
            + "\r\nContent-Length: "
            + content.length
            + (keep ? "\r\n\r\n" : "\r\nConnection: close\r\n\r\n");
    byte[] start = head.getBytes(StandardCharsets.ISO_8859_1);
    byte[] all = new byte[start.length + content.length];
    System.arraycopy(start, 0, all, 0, start.length);
    System.arraycopy(content, 0, all, start.length, content.length);
    return all;
  }
}
