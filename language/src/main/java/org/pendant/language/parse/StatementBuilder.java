package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;
import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Qualifier;

/**
 * Statement builder: turns ANTLR's statements into ours. Statements in which the parser met an
 * error are left out; a block whose head is broken stays, with what could be read of it.
 */
final class StatementBuilder {
  private final Source source;
  private final Complaints complaints;
  private final ExpressionBuilder expressions;

  StatementBuilder(Source source, Complaints complaints) {
    this.source = source;
    this.complaints = complaints;
    this.expressions = new ExpressionBuilder(source, complaints);
  }

  /** The statements that were built, in order. */
  static List<Statement> statements(List<StatementContext> contexts) {
    List<Statement> statements = new ArrayList<>(contexts.size());
    for (StatementContext context : contexts) {
      context.tree.ifPresent(statements::add);
    }
    return statements;
  }

  private static List<Statement> body(BlockContext context) {
    return statements(context.statement());
  }

  /** One complete statement, whose inner statements are built already. */
  Optional<Statement> build(StatementContext context) {
    ParseTree first = context.children.getFirst();
    if (first instanceof EffectContext effect) {
      return effect(effect);
    }
    SourceRange range = ExpressionBuilder.range(context);
    if (!(first instanceof TerminalNode terminal)) {
      return Optional.of(
          switch (first) {
            case ConditionalContext conditional -> conditional(conditional, range);
            case LoopContext loop ->
                new Statement.While(condition(loop.condition()), body(loop.block()), range);
            default -> definition((DefinitionContext) first, range);
          });
    }
    int type = terminal.getSymbol().getType();
    return Optional.of(
        switch (type) {
          case GLOBAL, LOCAL -> {
            SourceRange name = ExpressionBuilder.range((TerminalNode) context.children.get(1));
            yield new Statement.Assign(
                type == GLOBAL ? Qualifier.GLOBAL : Qualifier.LOCAL,
                new Expression.Name(source.text(name), name),
                expressions.build((ExpressionContext) context.children.get(3)),
                range);
          }
          case RETURN -> new Statement.Return(Optional.of(second(context)), range);
          case BARE_RETURN -> new Statement.Return(Optional.empty(), range);
          case BREAK -> new Statement.Break(range);
          case CONTINUE -> new Statement.Continue(range);
          case HALT -> new Statement.Halt(range);
          case PAUSE -> new Statement.Pause(range);
          case JOIN -> new Statement.Join(second(context), range);
          case KILL -> new Statement.Kill(second(context), range);
          case ENTER_CRITICAL -> new Statement.EnterCritical(range);
          case EXIT_CRITICAL -> new Statement.ExitCritical(range);
          default -> LabelText.parse(source.text(range)).at(range);
        });
  }

  private Expression second(StatementContext context) {
    return expressions.build((ExpressionContext) context.children.get(1));
  }

  private Optional<Statement> effect(EffectContext context) {
    ReferenceContext reference = (ReferenceContext) context.children.getFirst();
    Expression target = expressions.build(reference);
    SourceRange range = ExpressionBuilder.range(context);
    if (context.children.size() == 1) {
      return evaluate(target, range);
    }
    Expression value = expressions.build((ExpressionContext) context.children.get(2));
    return switch (target) {
      case Expression.Name _, Expression.Member _, Expression.Index _ ->
          Optional.of(new Statement.Assign(Qualifier.FREE, target, value, range));
      default -> {
        complaints.addAboutMeaning(
            "assignment-target",
            target.range(),
            text("notAssignable", Wording.shortened(source.text(target.range()))));
        yield Optional.empty();
      }
    };
  }

  private Optional<Statement> evaluate(Expression expression, SourceRange range) {
    return switch (expression) {
      case Expression.Call _, Expression.MethodCall _, Expression.Run _ ->
          Optional.of(new Statement.Evaluate(expression, range));
      case Expression.Name _ when !Wording.followsDigit(source, range) ->
          Optional.of(new Statement.Evaluate(expression, range));
      default -> {
        complaints.addAboutMeaning("no-effect", range, Wording.noEffect(source, expression));
        yield Optional.empty();
      }
    };
  }

  private Statement conditional(ConditionalContext context, SourceRange range) {
    List<Statement.Branch> branches = new ArrayList<>();
    BlockContext first = context.block(0);
    branches.add(
        branch(context.getStart().getStartIndex(), context.condition(), context.COLON(0), first));
    for (AlternativeContext alternative : context.alternative()) {
      branches.add(
          branch(
              alternative.getStart().getStartIndex(),
              alternative.condition(),
              alternative.COLON(),
              alternative.block()));
    }
    Optional<List<Statement>> otherwise =
        Optional.ofNullable(context.block(1)).map(StatementBuilder::body);
    return new Statement.If(branches, otherwise, range);
  }

  private Statement.Branch branch(
      int start, ConditionContext condition, TerminalNode colon, BlockContext block) {
    List<Statement> body = body(block);
    int end =
        body.isEmpty()
            ? Math.max(start, colon.getSymbol().getStopIndex() + 1)
            : body.getLast().range().end();
    return new Statement.Branch(condition(condition), body, new SourceRange(start, end));
  }

  private Expression condition(ConditionContext context) {
    if (context.exception == null) {
      return expressions.build((ExpressionContext) context.children.getFirst());
    }
    int start = context.getStart().getStartIndex();
    return new Expression.NoneLiteral(new SourceRange(start, start));
  }

  private Statement definition(DefinitionContext context, SourceRange range) {
    Statement.DefinitionKind kind =
        switch (context.getStart().getType()) {
          case DEF -> Statement.DefinitionKind.FUNCTION;
          case SEC -> Statement.DefinitionKind.SECONDARY;
          default -> Statement.DefinitionKind.THREAD;
        };
    HeadContext head = context.head();
    SourceRange nameRange =
        head.NAME() == null
            ? new SourceRange(head.getStart().getStartIndex(), head.getStart().getStartIndex())
            : ExpressionBuilder.range(head.NAME());
    List<ParameterDeclaration> parameters = new ArrayList<>();
    for (ParameterContext parameter : head.parameter()) {
      if (parameter.exception == null) {
        parameters.add(parameter(parameter));
      }
    }
    if (kind == Statement.DefinitionKind.THREAD && !parameters.isEmpty()) {
      complaints.addAboutMeaning(
          "thread-parameters",
          parameters.getFirst().range(),
          text("threadParameters", source.text(nameRange)));
    }
    int headEnd = Math.max(range.start(), context.COLON().getSymbol().getStopIndex() + 1);
    return new Statement.Definition(
        kind,
        source.text(nameRange),
        nameRange,
        parameters,
        body(context.block()),
        new SourceRange(range.start(), headEnd),
        range);
  }

  private ParameterDeclaration parameter(ParameterContext context) {
    ExpressionContext defaultValue = context.expression();
    return new ParameterDeclaration(
        context.NAME().getText(),
        defaultValue == null ? Optional.empty() : Optional.of(expressions.build(defaultValue)),
        ExpressionBuilder.range(context));
  }
}
