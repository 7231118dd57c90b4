package org.pendant.language.syntax;

import java.util.List;
import org.pendant.language.source.SourceRange;

/** Node: a piece of syntax that stands in the text of a script. */
public sealed interface Node
    permits Script, Statement, Statement.Branch, Expression, Argument, ParameterDeclaration {
  SourceRange range();

  /** What stands directly inside it, in the order of the text. */
  default List<Node> children() {
    return Children.of(this);
  }
}
