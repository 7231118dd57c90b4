package org.pendant.language.service;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.language.source.SourceRange;

/**
 * Hover: what is known about the name under the pointer, as ordinary text (not bytes).
 *
 * @param range the name
 * @param head one line of code, e.g. {@code movej(q, a=1.4, v=1.05, t=0, r=0)}
 * @param documentation what is written about it: in the reference of functions, or by people in
 *     their program; may be several lines
 * @param facts what was found out about it, a sentence each
 */
public record Hover(
    SourceRange range, String head, List<String> documentation, List<String> facts) {
  /** Copies the lists. */
  public Hover {
    documentation = List.copyOf(documentation);
    facts = List.copyOf(facts);
  }

  /** Documentation and facts, one a line; may be empty. */
  public String text() {
    return Stream.concat(documentation.stream(), facts.stream()).collect(Collectors.joining("\n"));
  }
}
