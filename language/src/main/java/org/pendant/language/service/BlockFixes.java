package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/** Fixes for blocks, brackets and whole lines. */
final class BlockFixes {
  private final ScriptAnalysis analysis;
  private final Lexemes lexemes;
  private final String text;
  private final int start;

  private BlockFixes(ScriptAnalysis analysis, int start) {
    this.analysis = analysis;
    this.lexemes = analysis.lexemes();
    this.text = analysis.source().text();
    this.start = start;
  }

  static List<QuickFix> propose(ScriptAnalysis analysis, Diagnostic diagnostic) {
    BlockFixes fixes = new BlockFixes(analysis, diagnostic.range().start());
    return switch (diagnostic.code()) {
      case "missing-end" -> fixes.missingEnd();
      case "missing-colon" -> fixes.behindPrevious(text("insert", ":"), ":");
      case "stray-end" ->
          List.of(fixes.withoutLine(text("removeThisEnd"), diagnostic.range().end()));
      case "trailing-call" ->
          List.of(fixes.withoutLine(text("removeTheCall"), diagnostic.range().end()));
      case "thread-arguments" -> fixes.emptyBrackets(text("removeTheArguments"));
      case "thread-parameters" -> fixes.emptyBrackets(text("removeTheParameters"));
      case "syntax-error" -> fixes.brackets();
      default -> List.of();
    };
  }

  /** Below the lines that stand further in than the opener, or at the end of the text. */
  private List<QuickFix> missingEnd() {
    Source source = analysis.source();
    String indentation = analysis.indentationAt(start);
    int line = source.line(start);
    int last = line;
    for (int i = line + 1; i <= source.lineCount(); i++) {
      String words = source.lineText(i);
      int in = words.length() - words.stripLeading().length();
      if (!words.isBlank() && in <= indentation.length()) {
        break;
      }
      last = words.isBlank() ? last : i;
    }
    String end = analysis.lineEnd() + indentation + "end";
    int lastWord = text.stripTrailing().length();
    QuickFix below = QuickFix.insert(text("insert", "end"), endOf(last), end);
    QuickFix atEnd = QuickFix.insert(text("insertEndAtEnd"), lastWord, end);
    // Nothing stands further in: the text is not indented and says nothing about its blocks.
    return last == line ? List.of(atEnd) : List.of(below, atEnd);
  }

  private List<QuickFix> behindPrevious(String title, String sign) {
    int before = lexemes.previous(lexemes.before(start) + 1);
    return before < 0
        ? List.of()
        : List.of(QuickFix.insert(title, lexemes.get(before).end(), sign));
  }

  /** A bracket that is not closed, or a head that has none. */
  private List<QuickFix> brackets() {
    List<QuickFix> fixes = new ArrayList<>();
    Optional<CallPlace> open = CallPlace.around(lexemes, start);
    // A line that begins a statement hides the bracket that the line before has left open.
    int before = lexemes.previous(lexemes.before(start) + 1);
    if (open.isEmpty() && before >= 0) {
      open = CallPlace.around(lexemes, lexemes.get(before).end());
    }
    open.ifPresent(
        place -> {
          String close = lexemes.reads(place.opener(), "(") ? ")" : "]";
          fixes.addAll(behindPrevious(text("insert", close), close));
        });
    if (lexemes.is(before, Kind.NAME) && lexemes.opensDefinition(before - 1)) {
      fixes.addAll(behindPrevious(text("insert", "()"), "()"));
    }
    return fixes;
  }

  private List<QuickFix> emptyBrackets(String title) {
    Optional<CallPlace> place = CallPlace.around(lexemes, start);
    if (place.isEmpty()) {
      return List.of();
    }
    int close = lexemes.close(place.get().opener());
    if (close == lexemes.size()) {
      return List.of();
    }
    int from = lexemes.get(place.get().opener()).end();
    int to = lexemes.get(close).start();
    return List.of(QuickFix.replace(title, from, to, ""));
  }

  /** From {@code start} to {@code end}, with the line if nothing else stands on it. */
  private QuickFix withoutLine(String title, int end) {
    int lineStart = text.lastIndexOf('\n', start - 1) + 1;
    int newline = text.indexOf('\n', end);
    int lineEnd = newline < 0 ? text.length() : newline + 1;
    boolean alone =
        text.substring(lineStart, start).isBlank() && text.substring(end, lineEnd).isBlank();
    return alone
        ? QuickFix.replace(title, lineStart, lineEnd, "")
        : QuickFix.replace(title, start, end, "");
  }

  /** The offset after the last byte of a line, before its line end. */
  private int endOf(int line) {
    int at = start;
    for (int i = analysis.source().line(start); i < line; i++) {
      at = text.indexOf('\n', at) + 1;
    }
    return at - analysis.source().column(at) + 1 + analysis.source().lineText(line).length();
  }
}
