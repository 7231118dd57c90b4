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
    return hint(found).or(() -> openBracket(found, start)).orElseGet(() -> expected(found, start));
  }

  /** {@code found} breaks the condition that began with {@code start}. */
  String inCondition(ScriptToken found, ScriptToken start) {
    if (found.is(ASSIGN)) {
      return ParseTexts.text("assignInCondition");
    }
    if (found == start && found.is(COLON)) {
      return ParseTexts.text("conditionMissing");
    }
    return unexpected(found, start);
  }

  /** {@code found} breaks the head of a definition, after its first word. */
  String inHead(ScriptToken found, ScriptToken start) {
    if (found == start) {
      return ParseTexts.text("expectedDefinitionName", shown(found));
    }
    ScriptToken previous = previous(found);
    if (previous == start) {
      return ParseTexts.text("parameterListMissing", text(start));
    }
    return openBracket(found, start)
        .orElseGet(() -> ParseTexts.text("expectedParameterName", shown(found)));
  }

  /** {@code found} stands after a complete head, on the same line, where its colon should be. */
  String behindHead(ScriptToken found) {
    if (found.is(ASSIGN)) {
      return ParseTexts.text("assignInCondition");
    }
    return hint(found)
        .orElseGet(
            () -> ParseTexts.text("expectedOperatorOrColon", shown(found), shown(previous(found))));
  }

  String missingColon(ScriptToken found) {
    int at = found.getTokenIndex() - 1;
    while (at > 0 && !headWord(tokens.get(at))) {
      at--;
    }
    ScriptToken word = tokens.get(Math.max(0, at));
    return found.getLine() == word.getLine()
        ? ParseTexts.text("colonMissing", text(word), shown(found))
        : ParseTexts.text("colonMissingOnLine", text(word), word.getLine(), shown(found));
  }

  /** {@code found} stands where a statement should begin. */
  String betweenStatements(ScriptToken found) {
    if (TokenKinds.closesBracket(found.getType())) {
      return ParseTexts.text("strayBracket", shown(found));
    }
    return hint(found).orElseGet(() -> notAStatement(found));
  }

  private String notAStatement(ScriptToken found) {
    ScriptToken previous = previous(found);
    boolean sameLine = previous != found && !found.firstOnLine();
    switch (found.getType()) {
      case EQUAL -> {
        return ParseTexts.text("equalAsStatement");
      }
      case ASSIGN -> {
        return previous.firstOnLine()
            ? ParseTexts.text("assignAfterUnfinishedLine", text(previous))
            : ParseTexts.text("assignTwice");
      }
      case PLUS, MINUS -> {
        ScriptToken next = tokens.get(Math.min(found.getTokenIndex() + 1, tokens.size() - 1));
        if (sameLine && next.is(found.getType()) && previous.is(NAME)) {
          String sign = text(found);
          String name = text(previous);
          return ParseTexts.text(
              "doesNotExistWrite", name + sign + sign, name + " = " + name + " " + sign + " 1");
        }
      }
      case LINE_PLUS, LINE_MINUS, LINE_LPAREN, LINE_LBRACK -> {
        return ParseTexts.text("lineBeginsWithOperator", shown(found));
      }
      case LPAREN -> {
        return ParseTexts.text("callOfNoFunction");
      }
      default -> {}
    }
    return sameLine
        ? ParseTexts.text("expectedStatementBehind", shown(found), shown(previous))
        : ParseTexts.text("expectedStatement", shown(found));
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
      return Optional.of(ParseTexts.text("stringsInARow"));
    }
    if (!found.is(STRANGE)) {
      return Optional.empty();
    }
    return Optional.of(
        switch (text(found).charAt(0)) {
          case '$' -> ParseTexts.text("labelNotAlone");
          case '\'' -> ParseTexts.text("apostropheNoString");
          case '{', '}' -> ParseTexts.text("bracesNoBlock", shown(found));
          case '\\' ->
              previousStringEndsInBackslash(found)
                  ? ParseTexts.text("noEscapes")
                  : ParseTexts.text("noLineContinuation");
          default -> ParseTexts.text("strangeCharacter", shown(found));
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
    String place = bracket.getLine() + ":" + source.column(bracket.startOffset());
    boolean afterValue = TokenKinds.endsOperand(previous(found).getType());
    if (TokenKinds.closesBracket(found.getType()) && afterValue) {
      return Optional.of(
          ParseTexts.text("wrongClosingBracket", shown(found), text(bracket), place, close));
    }
    if (found.firstOnLine()
        || found.is(Token.EOF)
        || found.is(COLON)
        || TokenKinds.beginsStatementForSure(found.getType())) {
      return Optional.of(
          ParseTexts.text("bracketNotClosed", text(bracket), place, shown(found), close));
    }
    if (found.is(ASSIGN) && round) {
      return Optional.of(ParseTexts.text("assignInBrackets"));
    }
    return Optional.of(
        afterValue
            ? ParseTexts.text(
                "expectedOperatorOrBracket", shown(found), close, text(bracket), place)
            : ParseTexts.text("expectedValue", shown(found)));
  }

  private String expected(ScriptToken found, ScriptToken start) {
    String shown = shown(found);
    ScriptToken previous = previous(found);
    if (start.is(GLOBAL) || start.is(LOCAL)) {
      if (previous == start) {
        return ParseTexts.text("expectedVariableName", shown, text(start));
      }
      if (found.getTokenIndex() == start.getTokenIndex() + 2) {
        return ParseTexts.text("expectedAssignment", shown, text(start), text(previous));
      }
    }
    return switch (previous.getType()) {
      case RUN -> ParseTexts.text("expectedThreadName", shown);
      case DOT -> ParseTexts.text("expectedMemberName", shown);
      case NAME ->
          tokens.get(Math.max(0, previous.getTokenIndex() - 1)).is(RUN)
              ? ParseTexts.text("expectedRunParentheses", shown, text(previous))
              : ParseTexts.text("expectedOperatorOrStatement", shown);
      default -> ParseTexts.text("expectedValueBehind", shown, shown(previous));
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
    return token.is(Token.EOF)
        ? ParseTexts.text("endOfText")
        : "`" + Wording.shortened(text(token)) + "`";
  }

  private String text(ScriptToken token) {
    return token.is(Token.EOF) ? "" : source.text(token.range());
  }
}
