package org.pendant.language.service;

import java.util.List;

/** Format result: what a request to format came to. */
public sealed interface FormatResult {

  /** Edits of blanks and line ends only; none when the text is laid out already. */
  record Formatted(List<TextEdit> edits) implements FormatResult {
    public Formatted {
      edits = List.copyOf(edits);
    }
  }

  /** The text cannot be read as a whole, for a reason to show to the user. */
  record Refused(String reason) implements FormatResult {}
}
