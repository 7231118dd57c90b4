package org.pendant.controller.message;

import static org.pendant.controller.message.MessageTexts.text;

import java.util.Optional;

/**
 * Prepared answer: known before its question.
 *
 * @param line {@code TEXT=VALUE} answers the question TEXT, {@code =VALUE} whatever is asked next;
 *     bytes, one {@code char} a byte
 */
public record PreparedAnswer(String line) {
  private static final String SEPARATOR = "=";

  /**
   * Checks the form.
   *
   * @throws IllegalArgumentException if there is no {@code =}
   */
  public PreparedAnswer {
    if (!line.contains(SEPARATOR)) {
      throw new IllegalArgumentException(text("preparedAnswer", line));
    }
  }

  /**
   * The value if this one names {@code question}. The question says where the value begins, as
   * either may have a {@code =} inside.
   */
  Optional<String> valueFor(String question) {
    return line.startsWith(question + SEPARATOR)
        ? Optional.of(line.substring(question.length() + 1))
        : Optional.empty();
  }

  /** The value if this one is for whatever is asked next. */
  Optional<String> valueInOrder() {
    return line.startsWith(SEPARATOR) ? Optional.of(line.substring(1)) : Optional.empty();
  }
}
