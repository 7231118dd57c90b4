package org.pendant.protocols.http;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;

/**
 * HTTP request.
 *
 * @param method such as {@code POST}
 * @param path what it is about, without a query
 * @param headers names in small letters, values as they came
 * @param keep whether the connection stays for another one
 * @param body what came with it; empty if it was not kept
 * @param notKept why the body was not kept, too large or too many at once; usually empty
 */
public record HttpCall(
    String method,
    String path,
    Map<String, String> headers,
    boolean keep,
    ByteBuffer body,
    Optional<HttpStatus> notKept) {
  /** Copies the map. */
  public HttpCall {
    headers = Map.copyOf(headers);
  }
}
