package org.pendant.language.service;

import java.util.List;
import org.pendant.language.source.SourceRange;

/**
 * Outline item: one line of the outline.
 *
 * @param detail the parameters of a function as in its head, e.g. {@code (place, height=0.1)}
 * @param range the whole definition; for a variable its name
 * @param nameRange the name alone
 * @param children what is defined inside, in the order of the text
 */
public record OutlineItem(
    Kind kind,
    String name,
    String detail,
    SourceRange range,
    SourceRange nameRange,
    List<OutlineItem> children) {

  /** What a line of the outline names. */
  public enum Kind {
    FUNCTION,
    SECONDARY,
    THREAD,
    /** A global variable, at its first assignment. */
    GLOBAL
  }

  public OutlineItem {
    children = List.copyOf(children);
  }
}
