package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/**
 * Token repair: reports mistakes whose meaning is plain from the tokens alone, habits of other
 * languages mostly, and puts what was meant in their place, so that they cause no further errors.
 */
final class TokenRepair {
  /** Words of other languages that begin a line inside a block of theirs. */
  private static final Set<String> INNER_WORDS =
      Set.of("case", "default", "except", "catch", "finally");

  private static final Set<String> FUNCTION_WORDS = Set.of("function", "func", "fun", "proc");

  private static final Set<String> ELIF_WORDS = Set.of("elseif", "elsif");

  private static final Set<String> END_WORDS =
      Set.of("endif", "endwhile", "enddef", "endfunction", "endthread", "endfor", "End", "END");

  /** Block words in the wrong case. */
  private static final Map<String, Integer> BLOCK_WORDS =
      Map.of(
          "def", DEF, "sec", SEC, "thread", THREAD, "if", IF, "elif", ELIF, "else", ELSE, "while",
          WHILE);

  private final Source source;
  private final Complaints complaints;
  private final List<ScriptToken> mended = new ArrayList<>();
  private final Deque<ScriptToken> openBrackets = new ArrayDeque<>();
  private List<ScriptToken> tokens = List.of();

  TokenRepair(Source source, Complaints complaints) {
    this.source = source;
    this.complaints = complaints;
  }

  /** The tokens as they were meant; incomplete once there are too many errors. */
  List<ScriptToken> mend(List<ScriptToken> broken) {
    tokens = broken;
    int at = 0;
    while (at < tokens.size() && !complaints.full()) {
      ScriptToken token = tokens.get(at);
      if (token.firstOnLine() && token.depth() == 0) {
        openBrackets.clear();
      }
      at = token.is(NAME) && startsStatement(at) ? word(at) : sign(at);
    }
    return mended;
  }

  private boolean startsStatement(int at) {
    ScriptToken token = tokens.get(at);
    return token.depth() == 0 && (token.firstOnLine() || tokens.get(at - 1).is(COLON));
  }

  /** Mends one token that is not a word at the start of a statement; the index after it. */
  private int sign(int at) {
    ScriptToken token = tokens.get(at);
    switch (token.getType()) {
      case SEMICOLON -> {
        complain("semicolon", token, ParseTexts.text("semicolon"));
        return at + 1;
      }
      case SLASH_COMMENT -> {
        complain("comment", token, ParseTexts.text("slashComment"));
        return at + 1;
      }
      case SINGLE_QUOTED ->
          replace(
              token,
              STRING,
              "single-quotes",
              ParseTexts.text("singleQuotes", Wording.shortened(inner(token))));
      case OPEN_STRING -> {
        replace(token, STRING, "unclosed-string", ParseTexts.text("unclosedString"));
        closeLine(token, tokens.get(at + 1));
        return at + 1;
      }
      case ARITHMETIC_ASSIGN -> {
        String sign = text(token);
        String target = at == 0 ? "x" : text(tokens.get(at - 1));
        replace(
            token,
            ASSIGN,
            "arithmetic-assign",
            ParseTexts.text(
                "doesNotExistWrite",
                sign,
                target + " = " + target + " " + sign.charAt(0) + " ..."));
      }
      case COLON_ASSIGN -> replace(token, ASSIGN, "colon-assign", ParseTexts.text("colonAssign"));
      case DOUBLE_AMPERSAND ->
          replace(token, AND, "and-sign", ParseTexts.text("doesNotExistWrite", "&&", "and"));
      case DOUBLE_BAR ->
          replace(token, OR, "or-sign", ParseTexts.text("doesNotExistWrite", "||", "or"));
      case ANGLES ->
          replace(
              token, NOT_EQUAL, "unequal-sign", ParseTexts.text("doesNotExistWrite", "<>", "!="));
      case ELSE -> {
        ScriptToken next = tokens.get(at + 1);
        if (next.is(IF) && !next.firstOnLine()) {
          replace(token, ELIF, "else-if", ParseTexts.text("elseIf"));
          mended.add(token);
          return at + 2;
        }
      }
      default -> {
        if (TokenKinds.opensBracket(token.getType())) {
          openBrackets.push(token);
        } else if (TokenKinds.closesBracket(token.getType())) {
          openBrackets.poll();
        }
      }
    }
    mended.add(token);
    return at + 1;
  }

  /** Mends a name that begins a statement but was meant as a word; the index after it. */
  private int word(int at) {
    ScriptToken token = tokens.get(at);
    String word = text(token);
    boolean alone = at + 1 < tokens.size() && endsLine(at);
    if (alone && END_WORDS.contains(word)) {
      replace(token, END, "end-word", ParseTexts.text("endWord", word));
      mended.add(token);
      return at + 1;
    }
    int colon = headColon(at);
    if (colon < 0) {
      return sign(at);
    }
    String lower = word.toLowerCase(Locale.ROOT);
    if (ELIF_WORDS.contains(lower)) {
      replace(token, ELIF, "else-if", ParseTexts.text("doesNotExistWrite", word, "elif"));
    } else if (BLOCK_WORDS.containsKey(lower)) {
      replace(token, BLOCK_WORDS.get(lower), "word-case", ParseTexts.text("wordCase", word, lower));
    } else if (FUNCTION_WORDS.contains(lower) && tokens.get(at + 1).is(NAME)) {
      replace(token, DEF, "function-word", ParseTexts.text("functionWord", word));
    } else {
      return foreignBlock(at, colon);
    }
    mended.add(token);
    return at + 1;
  }

  /** A line {@code word ... :} that opens no block we know: kept as a loop, so ends stay paired. */
  private int foreignBlock(int at, int colon) {
    ScriptToken token = tokens.get(at);
    String word = text(token);
    String lower = word.toLowerCase(Locale.ROOT);
    String shown = Wording.shortened(word);
    complain(
        "unknown-block",
        token,
        switch (lower) {
          case "for", "foreach", "repeat" -> ParseTexts.text("noForLoop", shown);
          case "switch", "match", "select", "case", "default" -> ParseTexts.text("noSwitch", shown);
          case "try", "except", "catch", "finally" -> ParseTexts.text("noCatch", shown);
          default -> ParseTexts.text("unknownBlock", shown);
        });
    if (!INNER_WORDS.contains(lower)) {
      token.setType(WHILE);
      mended.add(token);
      mended.add(ScriptToken.missing(TRUE, tokens.get(colon)));
      mended.add(tokens.get(colon));
    }
    return colon + 1;
  }

  /** The colon of a head that begins at {@code at}; -1 if the line is no head. */
  private int headColon(int at) {
    for (int i = at + 1; !tokens.get(i).firstOnLine() && !tokens.get(i).is(Token.EOF); i++) {
      int type = tokens.get(i).getType();
      if (tokens.get(i).depth() == 0) {
        if (type == COLON) {
          return i;
        }
        if (type == ASSIGN || TokenKinds.beginsStatementForSure(type)) {
          return -1;
        }
      }
    }
    return -1;
  }

  private boolean endsLine(int at) {
    ScriptToken next = tokens.get(at + 1);
    return next.firstOnLine() || next.is(Token.EOF);
  }

  /** A string that ran to the end of its line took the brackets and the colon there with it. */
  private void closeLine(ScriptToken string, ScriptToken next) {
    mended.add(string);
    while (!openBrackets.isEmpty()) {
      int opener = openBrackets.pop().getType();
      boolean round = opener == LPAREN || opener == LINE_LPAREN;
      mended.add(ScriptToken.missing(round ? RPAREN : RBRACK, next));
    }
    int first = mended.size() - 1;
    while (first > 0 && !mended.get(first).firstOnLine()) {
      first--;
    }
    int word = mended.get(first).getType();
    if (TokenKinds.opensBlock(word) || word == ELIF) {
      mended.add(ScriptToken.missing(COLON, next));
    }
  }

  private String inner(ScriptToken token) {
    String quoted = text(token);
    return quoted.substring(1, quoted.length() - 1);
  }

  private String text(ScriptToken token) {
    return source.text(token.range());
  }

  private void replace(ScriptToken token, int type, String code, String message) {
    complain(code, token, message);
    token.setType(type);
  }

  private void complain(String code, ScriptToken token, String message) {
    complaints.add(code, token.range(), message);
  }
}
