package org.pendant.language.service;

import org.pendant.language.source.SourceRange;

/**
 * Completion: one item that may be typed at the caret.
 *
 * @param label the name as the list shows it
 * @param detail what stands beside it, e.g. a head with units; may be empty
 * @param documentation one sentence; may be empty
 * @param replaced what {@code insert} takes the place of: the word at the caret
 * @param insert the new text, which may have several lines
 * @param caret where in {@code insert} the caret belongs
 */
public record Completion(
    Kind kind,
    String label,
    String detail,
    String documentation,
    SourceRange replaced,
    String insert,
    int caret) {

  /** What is offered, nearest first: among equally good matches the earlier kind comes first. */
  public enum Kind {
    /** {@code name=} in a call. */
    ARGUMENT,
    MEMBER,
    METHOD,
    PARAMETER,
    LOCAL,
    GLOBAL,
    /** A function of this text. */
    FUNCTION,
    THREAD,
    KEYWORD,
    /** A statement with its block. */
    SNIPPET,
    BUILTIN
  }
}
