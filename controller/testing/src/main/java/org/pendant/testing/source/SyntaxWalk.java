package org.pendant.testing.source;

import java.util.List;
import java.util.function.Consumer;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.Statement;

/** Walk through all expressions of a piece of syntax, outer ones first. */
final class SyntaxWalk {
  private final Consumer<Expression> visitor;
  private final boolean intoDefinitions;

  private SyntaxWalk(Consumer<Expression> visitor, boolean intoDefinitions) {
    this.visitor = visitor;
    this.intoDefinitions = intoDefinitions;
  }

  /** Shows every expression of {@code statements}, those of functions inside included. */
  static void all(List<Statement> statements, Consumer<Expression> visitor) {
    new SyntaxWalk(visitor, true).statements(statements);
  }

  /** As {@link #all}, without the functions inside. */
  static void ownOf(List<Statement> statements, Consumer<Expression> visitor) {
    new SyntaxWalk(visitor, false).statements(statements);
  }

  private void statements(List<Statement> statements) {
    statements.forEach(this::node);
  }

  private void node(Node node) {
    if (node instanceof Expression expression) {
      visitor.accept(expression);
    }
    if (node instanceof Statement.Definition definition && !intoDefinitions) {
      definition.parameters().forEach(this::node);
    } else {
      node.children().forEach(this::node);
    }
  }
}
