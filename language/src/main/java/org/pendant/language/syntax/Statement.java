package org.pendant.language.syntax;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.language.source.SourceRange;

/** One statement; definitions of functions, secondary programs and threads are statements too. */
public sealed interface Statement extends Node {

  /** The word before the name in an assignment (manual 9). */
  enum Qualifier {
    FREE,
    LOCAL,
    GLOBAL
  }

  /** The word that opens a definition. */
  enum DefinitionKind {
    FUNCTION,
    SECONDARY,
    THREAD
  }

  /**
   * {@code target = value}. The target is a {@link Expression.Name}, {@link Expression.Member} or
   * {@link Expression.Index}; with a qualifier it is always a name.
   */
  record Assign(Qualifier qualifier, Expression target, Expression value, SourceRange range)
      implements Statement {}

  /** An expression evaluated for its effect: a call or {@code run}, or a name, which has none. */
  record Evaluate(Expression expression, SourceRange range) implements Statement {}

  /** {@code if / elif ... / else / end}. */
  record If(List<Branch> branches, Optional<List<Statement>> otherwise, SourceRange range)
      implements Statement {
    public If {
      branches = List.copyOf(branches);
      otherwise = otherwise.map(List::copyOf);
    }
  }

  /** One {@code if} or {@code elif} arm; its range runs from the keyword to the end of the body. */
  record Branch(Expression condition, List<Statement> body, SourceRange range) implements Node {
    public Branch {
      body = List.copyOf(body);
    }
  }

  record While(Expression condition, List<Statement> body, SourceRange range) implements Statement {
    public While {
      body = List.copyOf(body);
    }
  }

  record Break(SourceRange range) implements Statement {}

  record Continue(SourceRange range) implements Statement {}

  record Halt(SourceRange range) implements Statement {}

  record Pause(SourceRange range) implements Statement {}

  /** {@code return}, with its value if one is written. */
  record Return(Optional<Expression> value, SourceRange range) implements Statement {}

  record Join(Expression handle, SourceRange range) implements Statement {}

  record Kill(Expression handle, SourceRange range) implements Statement {}

  record EnterCritical(SourceRange range) implements Statement {}

  record ExitCritical(SourceRange range) implements Statement {}

  /** A program label line ({@code $ 2 "text"}, manual 11); it has no effect when run. */
  record Label(Optional<Integer> number, String text, SourceRange range) implements Statement {}

  /**
   * A definition. {@code range} runs from the opening word to {@code end}; {@code headRange} is the
   * first line of it, from the opening word to the colon.
   */
  record Definition(
      DefinitionKind kind,
      String name,
      SourceRange nameRange,
      List<ParameterDeclaration> parameters,
      List<Statement> body,
      SourceRange headRange,
      SourceRange range)
      implements Statement {
    public Definition {
      parameters = List.copyOf(parameters);
      body = List.copyOf(body);
    }

    /** How it is called, for messages: {@code place(target, height=...)}. */
    public String head() {
      return parameters.stream()
          .map(each -> each.defaultValue().isEmpty() ? each.name() : each.name() + "=...")
          .collect(Collectors.joining(", ", name + "(", ")"));
    }
  }
}
