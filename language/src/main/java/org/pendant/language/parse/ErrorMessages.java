package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/** Error messages: say what the parser found, what would be right, and what was probably meant. */
final class ErrorMessages {
  private final Source source;
  private final TokenArray tokens;

  ErrorMessages(Source source, TokenArray tokens) {
    this.source = source;
    this.tokens = tokens;
  }

  /** {@code found} does not continue the statement that began with {@code start}. */
  String unexpected(ScriptToken found, ScriptToken start) {
    return hint(found)
        .or(() -> openBracket(found, start))
        .orElseGet(() -> "unexpected " + shown(found) + ": " + expected(found, start));
  }

  /** {@code found} breaks the condition that began with {@code start}. */
  String inCondition(ScriptToken found, ScriptToken start) {
    if (found.is(ASSIGN)) {
      return "`=` assigns and cannot stand in a condition: compare with `==`";
    }
    if (found == start && found.is(COLON)) {
      return "the condition is missing in front of `:`";
    }
    return unexpected(found, start);
  }

  /** {@code found} breaks the head of a definition, after its first word. */
  String inHead(ScriptToken found, ScriptToken start) {
    if (found == start) {
      return "unexpected " + shown(found) + ": expected the name of the definition";
    }
    ScriptToken previous = previous(found);
    if (previous == start) {
      return "missing `()`: a definition names its parameters, `" + text(start) + "():`";
    }
    return openBracket(found, start)
        .orElseGet(() -> "unexpected " + shown(found) + ": expected a parameter name");
  }

  /** {@code found} stands after a complete head, on the same line, where its colon should be. */
  String behindHead(ScriptToken found) {
    if (found.is(ASSIGN)) {
      return "`=` assigns and cannot stand in a condition: compare with `==`";
    }
    return hint(found)
        .orElseGet(
            () ->
                "unexpected "
                    + shown(found)
                    + " behind "
                    + shown(previous(found))
                    + ": expected an operator or `:`");
  }

  String missingColon(ScriptToken found) {
    int at = found.getTokenIndex() - 1;
    while (at > 0 && !headWord(tokens.get(at))) {
      at--;
    }
    ScriptToken word = tokens.get(Math.max(0, at));
    String line = found.getLine() == word.getLine() ? "" : " on line " + word.getLine();
    return "missing `:` behind the head of `" + text(word) + "`" + line + ": found " + shown(found);
  }

  /** {@code found} stands where a statement should begin. */
  String betweenStatements(ScriptToken found) {
    if (TokenKinds.closesBracket(found.getType())) {
      return shown(found) + " closes nothing: no bracket is open here";
    }
    return hint(found).orElseGet(() -> notAStatement(found));
  }

  private String notAStatement(ScriptToken found) {
    ScriptToken previous = previous(found);
    boolean sameLine = previous != found && !found.firstOnLine();
    switch (found.getType()) {
      case EQUAL -> {
        return "`==` compares: assign with `=`";
      }
      case ASSIGN -> {
        return previous.firstOnLine()
            ? "unexpected `=`: the line before is not finished, so `"
                + text(previous)
                + "` was taken as part of it"
            : "unexpected `=`: a statement assigns once";
      }
      case PLUS, MINUS -> {
        ScriptToken next = tokens.get(Math.min(found.getTokenIndex() + 1, tokens.size() - 1));
        if (sameLine && next.is(found.getType()) && previous.is(NAME)) {
          String sign = text(found);
          String name = text(previous);
          return String.format(
              "`%s%s%s` does not exist: write `%s = %s %s 1`", name, sign, sign, name, name, sign);
        }
      }
      case LINE_PLUS, LINE_MINUS, LINE_LPAREN, LINE_LBRACK -> {
        return "a line cannot begin with "
            + shown(found)
            + ": to continue the line before, end that one with an operator or a comma";
      }
      case LPAREN -> {
        return "unexpected `(`: only a function or a method can be called";
      }
      default -> {}
    }
    return "unexpected "
        + shown(found)
        + (sameLine ? " behind " + shown(previous) : "")
        + ": expected a statement";
  }

  /** Tokens that are wrong wherever they stand. */
  private Optional<String> hint(ScriptToken found) {
    ScriptToken previous = previous(found);
    boolean adjacent = previous != found && previous.endOffset() == found.startOffset();
    if (adjacent && found.is(NAME) && (previous.is(INT) || previous.is(FLOAT))) {
      return Optional.of(Wording.behindNumber(source, found.range()));
    }
    if (adjacent && (found.is(PLUS) || found.is(MINUS)) && endsNumber(previous)) {
      return Optional.of(Wording.behindNumber(source, previous.range()));
    }
    if (found.is(STRING) && previous.is(STRING)) {
      return Optional.of("two strings in a row: join them with `+`");
    }
    if (!found.is(STRANGE)) {
      return Optional.empty();
    }
    return Optional.of(
        switch (text(found).charAt(0)) {
          case '$' -> "a `$` label stands on a line of its own";
          case '\'' -> "`'` begins no string: strings stand in double quotes";
          case '{', '}' ->
              shown(found) + " has no meaning: blocks open with `:` and close with `end`";
          case '\\' ->
              previousStringEndsInBackslash(found)
                  ? "strings have no escapes: `\\` is an ordinary byte and a quote cannot be"
                      + " written in a string"
                  : "`\\` does not continue a line: a line may break in brackets or behind an"
                      + " operator";
          default -> shown(found) + " has no meaning outside strings and comments";
        });
  }

  /** Whether {@code name} is the mark of an exponent at the end of a number. */
  private boolean endsNumber(ScriptToken name) {
    ScriptToken number = previous(name);
    return name.is(NAME)
        && text(name).equalsIgnoreCase("e")
        && number.endOffset() == name.startOffset()
        && (number.is(INT) || number.is(FLOAT));
  }

  /** Whether this follows from an attempt to write a quote inside a string. */
  private boolean previousStringEndsInBackslash(ScriptToken found) {
    for (int i = found.getTokenIndex() - 1;
        i >= 0 && tokens.get(i).getLine() == found.getLine();
        i--) {
      if (tokens.get(i).is(STRING) && text(tokens.get(i)).endsWith("\\\"")) {
        return true;
      }
    }
    return false;
  }

  private Optional<String> openBracket(ScriptToken found, ScriptToken start) {
    Deque<ScriptToken> open = new ArrayDeque<>();
    for (int i = start.getTokenIndex(); i < found.getTokenIndex(); i++) {
      ScriptToken token = tokens.get(i);
      if (TokenKinds.opensBracket(token.getType())) {
        open.push(token);
      } else if (TokenKinds.closesBracket(token.getType())) {
        open.poll();
      }
    }
    if (open.isEmpty()) {
      return Optional.empty();
    }
    ScriptToken bracket = open.peek();
    boolean round = bracket.is(LPAREN) || bracket.is(LINE_LPAREN);
    String close = round ? "`)`" : "`]`";
    String place =
        "`"
            + text(bracket)
            + "` at "
            + bracket.getLine()
            + ":"
            + source.column(bracket.startOffset());
    boolean afterValue = TokenKinds.endsOperand(previous(found).getType());
    if (TokenKinds.closesBracket(found.getType()) && afterValue) {
      return Optional.of("unexpected " + shown(found) + ": " + place + " closes with " + close);
    }
    if (found.firstOnLine()
        || found.is(Token.EOF)
        || found.is(COLON)
        || TokenKinds.beginsStatementForSure(found.getType())) {
      return Optional.of(place + " is not closed: found " + shown(found) + ", expected " + close);
    }
    if (found.is(ASSIGN) && round) {
      return Optional.of("unexpected `=`: compare with `==`");
    }
    return Optional.of(
        "unexpected "
            + shown(found)
            + (afterValue
                ? ": expected an operator, `,` or " + close + " for " + place
                : ": expected a value"));
  }

  private String expected(ScriptToken found, ScriptToken start) {
    ScriptToken previous = previous(found);
    if (start.is(GLOBAL) || start.is(LOCAL)) {
      if (previous == start) {
        return "expected a variable name behind `" + text(start) + "`";
      }
      if (found.getTokenIndex() == start.getTokenIndex() + 2) {
        return "expected `=` and a value behind `" + text(start) + " " + text(previous) + "`";
      }
    }
    return switch (previous.getType()) {
      case RUN -> "expected the name of a thread, `run name()`";
      case DOT -> "expected the name of a member or a method";
      case NAME ->
          tokens.get(Math.max(0, previous.getTokenIndex() - 1)).is(RUN)
              ? "expected `()`, as in `run " + text(previous) + "()`"
              : "expected an operator or a new statement";
      default -> "expected a value behind " + shown(previous);
    };
  }

  private static boolean headWord(ScriptToken token) {
    return TokenKinds.opensBlock(token.getType()) || token.is(ELIF) || token.is(ELSE);
  }

  /** The token in front of {@code found}; itself if it is the first. */
  private ScriptToken previous(ScriptToken found) {
    return tokens.get(Math.max(0, found.getTokenIndex() - 1));
  }

  private String shown(ScriptToken token) {
    if (!token.is(Token.EOF) && token.endOffset() <= token.startOffset()) {
      // Mended in: what really stands there is the next token.
      return shown(tokens.get(token.getTokenIndex() + 1));
    }
    return token.is(Token.EOF) ? "the end of the text" : "`" + Wording.shortened(text(token)) + "`";
  }

  private String text(ScriptToken token) {
    return token.is(Token.EOF) ? "" : source.text(token.range());
  }
}
