package org.pendant.protocols.robotapi;

import java.util.List;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpStatus;

/** API replies: answers in the forms of the API. */
final class ApiReply {
  private static final String JSON = "application/json";

  private ApiReply() {}

  /** What was asked for. */
  static HttpReply of(JsonText answer) {
    return new HttpReply(HttpStatus.OK, JSON, answer.text());
  }

  /** A text that is JSON already. */
  static HttpReply of(String json) {
    return new HttpReply(HttpStatus.OK, JSON, json);
  }

  /**
   * Something was not done.
   *
   * @param message what
   * @param details why
   */
  static HttpReply refused(HttpStatus status, String message, String details) {
    return new HttpReply(status, JSON, error(message, details));
  }

  /** There is such a path, for other methods. */
  static HttpReply otherMethod(List<String> allowed) {
    return new HttpReply(
        HttpStatus.METHOD_NOT_ALLOWED,
        JSON,
        error("Method Not Allowed", "must be " + String.join(" or ", allowed)),
        allowed);
  }

  private static String error(String message, String details) {
    return new JsonText().with("message", message).with("details", details).text();
  }
}
