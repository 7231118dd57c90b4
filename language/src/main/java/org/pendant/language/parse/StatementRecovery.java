package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;

import java.util.Optional;
import org.antlr.v4.runtime.ANTLRErrorStrategy;
import org.antlr.v4.runtime.InputMismatchException;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.pendant.language.parse.UrScriptParser.BlockContext;
import org.pendant.language.parse.UrScriptParser.ConditionContext;
import org.pendant.language.parse.UrScriptParser.HeadContext;
import org.pendant.language.parse.UrScriptParser.ScriptContext;
import org.pendant.language.parse.UrScriptParser.StatementContext;

/**
 * Statement recovery: continues after an error: a broken statement is skipped to the line where the
 * next one begins, a broken head to its colon. Errors travel up to the rule that can do so; no
 * token is guessed but a missing colon or {@code end}.
 */
final class StatementRecovery implements ANTLRErrorStrategy {
  private final TokenArray tokens;
  private final Complaints complaints;
  private final ErrorMessages messages;
  private final Optional<EarlierStatements> earlier;

  // Set between a broken head and the colon after it, which is then not asked for again.
  private boolean headBroken;

  StatementRecovery(
      TokenArray tokens,
      Complaints complaints,
      ErrorMessages messages,
      Optional<EarlierStatements> earlier) {
    this.tokens = tokens;
    this.complaints = complaints;
    this.messages = messages;
    this.earlier = earlier;
  }

  @Override
  public void reset(Parser recognizer) {
    headBroken = false;
  }

  @Override
  public Token recoverInline(Parser recognizer) {
    ScriptToken found = tokens.current();
    IntervalSet expected = recognizer.getExpectedTokens();
    if (expected.contains(UrScriptParser.COLON)) {
      return colon(recognizer, found);
    }
    if (expected.contains(UrScriptParser.END)) {
      complain(recognizer, "missing-end", found, text("endMissingBefore"));
      return ScriptToken.missing(UrScriptParser.END, found);
    }
    throw new InputMismatchException(recognizer);
  }

  private Token colon(Parser recognizer, ScriptToken found) {
    boolean forgotten =
        found.firstOnLine()
            || TokenKinds.beginsStatement(found.getType())
            || TokenKinds.endsBlock(found.getType())
            || found.is(Token.EOF);
    if (!headBroken) {
      if (forgotten) {
        complain(recognizer, "missing-colon", found, messages.missingColon(found));
      } else {
        complain(recognizer, "syntax-error", found, messages.behindHead(found));
        skipToColon(recognizer);
      }
    }
    headBroken = false;
    ScriptToken next = tokens.current();
    if (next.is(UrScriptParser.COLON)) {
      recognizer.consume();
      return next;
    }
    return ScriptToken.missing(UrScriptParser.COLON, next);
  }

  @Override
  public void recover(Parser recognizer, RecognitionException error) {
    ParserRuleContext context = recognizer.getContext();
    switch (context) {
      case StatementContext statement -> {
        ScriptToken found = tokens.current();
        complain(
            recognizer,
            "syntax-error",
            found,
            messages.unexpected(found, (ScriptToken) statement.start));
        if (found == statement.start) {
          recognizer.consume();
        }
        skipToStatement(recognizer);
      }
      case ConditionContext _, HeadContext _ -> {
        ScriptToken found = tokens.current();
        complain(
            recognizer,
            "syntax-error",
            found,
            context instanceof HeadContext
                ? messages.inHead(found, (ScriptToken) context.start)
                : messages.inCondition(found, (ScriptToken) context.start));
        headBroken = true;
        skipToColon(recognizer);
      }
      default -> throw error;
    }
  }

  /** Called where a statement may begin: whatever cannot begin one is reported and skipped. */
  @Override
  public void sync(Parser recognizer) {
    ParserRuleContext context = recognizer.getContext();
    boolean inBlock = context instanceof BlockContext;
    if (!inBlock && !(context instanceof ScriptContext)) {
      return;
    }
    headBroken = false;
    while (true) {
      earlier.ifPresent(known -> known.take(recognizer, tokens));
      ScriptToken found = tokens.current();
      int type = found.getType();
      if (type == Token.EOF
          || TokenKinds.beginsStatement(type)
          || (inBlock && TokenKinds.endsBlock(type))) {
        return;
      }
      complain(recognizer, "syntax-error", found, messages.betweenStatements(found));
      recognizer.consume();
      skipToStatement(recognizer);
    }
  }

  @Override
  public boolean inErrorRecoveryMode(Parser recognizer) {
    return false;
  }

  @Override
  public void reportMatch(Parser recognizer) {
    // Nothing is counted between errors.
  }

  @Override
  public void reportError(Parser recognizer, RecognitionException error) {
    // Reported by the rule that recovers, once.
  }

  private void complain(Parser recognizer, String code, ScriptToken found, String message) {
    complaints.add(code, found.range(), message);
    if (complaints.full()) {
      giveUp(recognizer);
    }
  }

  /** Every rule that is left halfway counts as broken: no code may build a statement of it. */
  private static void giveUp(Parser recognizer) {
    InputMismatchException reason = new InputMismatchException(recognizer);
    for (ParserRuleContext rule = recognizer.getContext(); rule != null; rule = rule.getParent()) {
      rule.exception = reason;
    }
    throw new ParseCancellationException("too many errors", reason);
  }

  private void skipToStatement(Parser recognizer) {
    while (true) {
      ScriptToken token = tokens.current();
      int type = token.getType();
      if (type == Token.EOF
          || TokenKinds.beginsStatementForSure(type)
          || (token.firstOnLine() && token.depth() == 0 && !TokenKinds.continuesLine(type))) {
        return;
      }
      recognizer.consume();
    }
  }

  private void skipToColon(Parser recognizer) {
    while (true) {
      ScriptToken token = tokens.current();
      int type = token.getType();
      if (type == Token.EOF
          || type == UrScriptParser.COLON
          || TokenKinds.beginsStatementForSure(type)
          || (token.firstOnLine() && token.depth() == 0)) {
        return;
      }
      recognizer.consume();
    }
  }
}
