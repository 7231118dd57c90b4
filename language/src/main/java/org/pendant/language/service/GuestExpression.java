package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Checker;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Guest expression: one that is not in a text, such as the condition of a breakpoint, read as if it
 * stood before one of its lines: names mean what they mean there. Immutable; any thread may make
 * it.
 */
public final class GuestExpression {
  private static final String BEFORE = "if (";
  private static final String BEHIND = "):\nend\n";

  private final Optional<Diagnostic> refusal;
  private final ScriptAnalysis analysis;
  private final int start;
  private final int length;

  private GuestExpression(Source source, Catalogue catalogue, int line, String expression) {
    String text = source.text();
    int at = lineStart(text, line);
    start = at + BEFORE.length();
    length = expression.length();
    refusal = refusal(Lexemes.of(bytes("expression", expression)));
    analysis =
        ScriptAnalysis.of(
            bytes(
                source.name(),
                text.substring(0, at) + BEFORE + expression + BEHIND + text.substring(at)),
            catalogue);
  }

  /**
   * Reads {@code expression} as if it stood before a line of a text.
   *
   * @param source the text
   * @param line of it, counted from 1
   * @param expression bytes, without line ends
   */
  public static GuestExpression of(
      Source source, Catalogue catalogue, int line, String expression) {
    return new GuestExpression(source, catalogue, line, expression);
  }

  private static int lineStart(String text, int line) {
    int start = 0;
    for (int i = 1; i < line && text.indexOf('\n', start) >= 0; i++) {
      start = text.indexOf('\n', start) + 1;
    }
    return start;
  }

  private static Source bytes(String name, String text) {
    return Source.of(name, text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** What is wrong with it, ranges counted from its start; nothing about the text around it. */
  public Optional<Diagnostic> problem() {
    if (refusal.isPresent()) {
      return refusal;
    }
    return analysis.diagnostics().stream()
        .filter(Checker::fails)
        .filter(each -> touches(each.range()))
        .map(this::own)
        .findFirst();
  }

  /** What may be typed at {@code offset} of it; insertions are counted from the caret as ever. */
  public List<Completion> completions(int offset) {
    return analysis.completions(start + Math.clamp(offset, 0, length));
  }

  private boolean touches(SourceRange range) {
    return range.end() >= start && range.start() <= start + length;
  }

  private Diagnostic own(Diagnostic found) {
    int from = Math.clamp((long) found.range().start() - start, 0, length);
    int to = Math.clamp((long) found.range().end() - start, from, length);
    return new Diagnostic(
        found.code(),
        found.severity(),
        new SourceRange(from, to),
        found.range().start() < start + length ? found.message() : atEnd(found.message()),
        found.wireText());
  }

  /**
   * What a fault after the last character of an expression is called: the bracket that was found
   * there is none of those that were typed.
   */
  public static String atEnd(String message) {
    String bracket = "unexpected `)`";
    return message.replace(bracket, bracket.replace("`)`", text("endOfExpression")));
  }

  /** Whatever would end the condition that it is put into, or is no expression at all. */
  private static Optional<Diagnostic> refusal(Lexemes lexemes) {
    int depth = 0;
    for (int i = 0; i < lexemes.size(); i++) {
      Lexeme each = lexemes.get(i);
      switch (each.kind()) {
        case OPEN -> depth++;
        case CLOSE -> {
          if (--depth < 0) {
            return wrong(each, text("closesNothing", lexemes.text(i)));
          }
        }
        case ASSIGN -> {
          if (depth == 0) {
            return wrong(each, text("assigns"));
          }
        }
        case OPENER, ALTERNATIVE, END, STATEMENT_WORD, COLON, LABEL -> {
          return wrong(each, text("partOfStatement", lexemes.text(i)));
        }
        case COMMENT -> {
          return wrong(each, text("comment"));
        }
        default -> {}
      }
    }
    return depth > 0
        ? wrong(lexemes.get(lexemes.size() - 1), text("bracketOpen"))
        : Optional.empty();
  }

  private static Optional<Diagnostic> wrong(Lexeme at, String message) {
    return Optional.of(Diagnostic.error("not-an-expression", at.range(), message, ""));
  }
}
