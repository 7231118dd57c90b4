package org.pendant.protocols.http;

import java.nio.ByteBuffer;
import java.util.Map;

/**
 * One request by HTTP.
 *
 * @param method such as {@code POST}
 * @param path what it is about, without a query
 * @param headers names and values in small letters
 * @param keep whether the connection stays for another one
 */
public record HttpCall(
    String method, String path, Map<String, String> headers, boolean keep, ByteBuffer body) {
  /** Copies the map. */
  public HttpCall {
    headers = Map.copyOf(headers);
  }
}
