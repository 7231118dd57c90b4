package org.pendant.language.parse;

import java.util.List;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.syntax.Script;

/**
 * Parse result: what a text says, and what is wrong with it.
 *
 * @param script the tree; where there are errors it lacks the statements that hold them, so it is
 *     good for outlines but not for checking or running
 * @param diagnostics syntax errors in the order of the text
 */
public record ParseResult(Script script, List<Diagnostic> diagnostics) {
  public ParseResult {
    diagnostics = List.copyOf(diagnostics);
  }

  /** Whether the text is free of syntax errors. */
  public boolean ok() {
    return diagnostics.stream().noneMatch(Diagnostic::isError);
  }
}
