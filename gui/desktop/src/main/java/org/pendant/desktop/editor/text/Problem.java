package org.pendant.desktop.editor.text;

import org.pendant.language.source.Diagnostic;

/**
 * Problem: a diagnostic where an editor shows it.
 *
 * @param span the characters that are underlined
 * @param line where it begins, from 1
 * @param column where it begins in the line, in characters from 1
 * @param message the diagnostic's message for people to read
 */
public record Problem(Diagnostic diagnostic, TextSpan span, int line, int column, String message) {

  /** Whether it keeps the program from running. */
  public boolean isError() {
    return diagnostic.isError();
  }
}
