package org.pendant.language.syntax;

import org.pendant.language.source.SourceRange;

/** Node: a piece of syntax that stands in the text of a script. */
public sealed interface Node
    permits Script, Statement, Statement.Branch, Expression, Argument, ParameterDeclaration {
  SourceRange range();
}
