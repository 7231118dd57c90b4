package org.pendant.language.parse;

import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.pendant.language.parse.UrScriptParser.BlockContext;
import org.pendant.language.parse.UrScriptParser.ScriptContext;
import org.pendant.language.parse.UrScriptParser.StatementContext;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Branch;

/**
 * Earlier statements: those of an earlier version of a text, handed to the parser in place of
 * tokens of which they were made before. Each decision of the grammar is taken on one token and
 * regards nothing around the statement, so a statement whose tokens are the same, with those that
 * end it, is the same.
 */
final class EarlierStatements {
  /** So many tokens behind a statement are the same as well; the parser has looked at one. */
  private static final int LOOKED_AHEAD = 2;

  private final List<Statement> statements;
  private final TextChange change;
  private final List<SourceRange> doubtful;
  private final Complaints complaints;

  /**
   * The statements of an earlier text.
   *
   * @param change what has become of it
   * @param complaints of the text that is read now: what they are about is read anew
   */
  EarlierStatements(ReadText before, TextChange change, Complaints complaints) {
    statements = before.result().script().statements();
    doubtful = change.moved(before.doubtful());
    this.change = change;
    this.complaints = complaints;
  }

  /**
   * To be called where a statement may begin: goes behind those that were read before and gives
   * them to the rule that the parser is in.
   */
  void take(Parser parser, TokenArray tokens) {
    ParserRuleContext context = parser.getContext();
    if (!(context instanceof BlockContext || context instanceof ScriptContext)) {
      return;
    }
    for (Optional<Statement> found = next(tokens); found.isPresent(); found = next(tokens)) {
      StatementContext statement = new StatementContext(context, parser.getState());
      statement.tree = found;
      context.addChild(statement);
      tokens.seek(tokens.indexAt(found.get().range().end()));
    }
  }

  private Optional<Statement> next(TokenArray tokens) {
    ScriptToken first = tokens.current();
    int start = first.startOffset();
    if (first.is(Token.EOF) || (start >= change.sameBefore() && start < change.sameFrom())) {
      return Optional.empty();
    }
    int shift = start < change.sameBefore() ? 0 : change.shift();
    Optional<Statement> found = beginningAt(statements, start - shift);
    if (found.isEmpty()) {
      return Optional.empty();
    }
    int behind = tokens.indexAt(found.get().range().end() + shift);
    ScriptToken last = tokens.get(Math.min(behind + LOOKED_AHEAD, tokens.size()) - 1);
    boolean same = start >= change.sameBefore() || last.startOffset() < change.sameBefore();
    return same && isPlain(start, last.endOffset())
        ? Optional.of(MovedTree.moved(found.get(), shift))
        : Optional.empty();
  }

  private boolean isPlain(int start, int end) {
    return isApart(doubtful, start, end) && isApart(complaints.places(), start, end);
  }

  private static boolean isApart(List<SourceRange> places, int start, int end) {
    for (SourceRange place : places) {
      if (place.start() <= end && place.end() >= start) {
        return false;
      }
    }
    return true;
  }

  private static Optional<Statement> beginningAt(List<Statement> statements, int offset) {
    List<Statement> among = statements;
    while (true) {
      int low = 0;
      int high = among.size();
      while (low < high) {
        int middle = (low + high) >>> 1;
        if (among.get(middle).range().start() <= offset) {
          low = middle + 1;
        } else {
          high = middle;
        }
      }
      if (low == 0) {
        return Optional.empty();
      }
      Statement found = among.get(low - 1);
      if (found.range().start() == offset) {
        return Optional.of(found);
      }
      among = offset < found.range().end() ? inside(found, offset) : List.of();
    }
  }

  private static List<Statement> inside(Statement statement, int offset) {
    return switch (statement) {
      case Statement.Definition definition -> definition.body();
      case Statement.While loop -> loop.body();
      case Statement.If choice -> {
        for (Branch branch : choice.branches()) {
          if (offset < branch.range().end()) {
            yield branch.body();
          }
        }
        yield choice.otherwise().orElse(List.of());
      }
      case Statement.Assign _,
          Statement.Evaluate _,
          Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.Return _,
          Statement.Join _,
          Statement.Kill _,
          Statement.EnterCritical _,
          Statement.ExitCritical _,
          Statement.Label _ ->
          List.of();
    };
  }
}
