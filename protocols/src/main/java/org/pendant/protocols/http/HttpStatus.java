package org.pendant.protocols.http;

/** HTTP status: what came of a request (RFC 9110, 15). */
public enum HttpStatus {
  OK(200, "OK"),
  BAD_REQUEST(400, "Bad Request"),
  FORBIDDEN(403, "Forbidden"),
  NOT_FOUND(404, "Not Found"),
  METHOD_NOT_ALLOWED(405, "Method Not Allowed"),
  CONFLICT(409, "Conflict"),
  TOO_LARGE(413, "Content Too Large"),
  UNPROCESSABLE(422, "Unprocessable Content"),
  INTERNAL(500, "Internal Server Error"),
  UNAVAILABLE(503, "Service Unavailable"),
  GATEWAY_TIMEOUT(504, "Gateway Timeout");

  private final int code;
  private final String reason;

  HttpStatus(int code, String reason) {
    this.code = code;
    this.reason = reason;
  }

  /** Its number. */
  public int code() {
    return code;
  }

  /** Its words. */
  String reason() {
    return reason;
  }
}
