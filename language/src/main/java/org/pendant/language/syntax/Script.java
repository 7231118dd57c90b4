package org.pendant.language.syntax;

import java.util.List;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Script: one parsed text: the top-level statements in order, definitions among them.
 *
 * @param source the text that the ranges of every node below point into
 */
public record Script(Source source, List<Statement> statements, SourceRange range) implements Node {
  public Script {
    statements = List.copyOf(statements);
  }
}
