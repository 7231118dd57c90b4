package org.pendant.models.json;

/**
 * JSON error: a file is not what it should be. The message says where ({@code file:line:column}),
 * what was found there and what would be right. Carries no stack trace, it is no fault of the
 * program.
 */
public final class JsonException extends Exception {
  private static final long serialVersionUID = 1L;

  JsonException(String message) {
    super(message, null, false, false);
  }
}
