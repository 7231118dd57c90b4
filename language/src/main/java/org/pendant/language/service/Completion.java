package org.pendant.language.service;

import java.util.List;
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
 * @param arguments names of the arguments that a call cannot do without, which an editor may put at
 *     the caret, separated by commas, as places to fill in; empty if there are none
 */
public record Completion(
    Kind kind,
    String label,
    String detail,
    String documentation,
    SourceRange replaced,
    String insert,
    int caret,
    List<String> arguments) {

  /** Copies the names. */
  public Completion {
    arguments = List.copyOf(arguments);
  }

  /**
   * What is offered, nearest first: among equally good matches the earlier kind comes first, and
   * among those of a kind what this text, and then what programs at large use most.
   */
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
