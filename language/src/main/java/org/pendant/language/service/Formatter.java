package org.pendant.language.service;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;

/**
 * Formatter: lays out a text without syntax errors by rewriting what lies between its lexemes.
 * Words, strings, labels and comments are not touched and no line is broken or joined, so the text
 * cannot come to mean something else.
 */
final class Formatter {
  /** Two blank lines in a row, no more. */
  private static final int MAX_LINE_ENDS = 3;

  private static final String BYTE_ORDER_MARK = "\u00EF\u00BB\u00BF";

  private final Lexemes lexemes;
  private final String text;
  private final String lineEnd;
  private final Indentation indentation;
  private final Spacing spacing;
  private final List<TextEdit> edits = new ArrayList<>();

  private Formatter(Lexemes lexemes, FormatOptions options) {
    this.lexemes = lexemes;
    text = lexemes.source().text();
    lineEnd = text.contains("\r\n") ? "\r\n" : "\n";
    indentation = new Indentation(lexemes, options.indentation());
    spacing = new Spacing(lexemes);
  }

  static List<TextEdit> edits(Lexemes lexemes, FormatOptions options) {
    Formatter formatter = new Formatter(lexemes, options);
    formatter.run();
    return formatter.edits;
  }

  private void run() {
    int end = text.startsWith(BYTE_ORDER_MARK) ? BYTE_ORDER_MARK.length() : 0;
    for (int i = 0; i < lexemes.size(); i++) {
      Lexeme lexeme = lexemes.get(i);
      String gap = text.substring(end, lexeme.start());
      int indent = indentation.pass(i);
      String blanks = spacing.pass(i, gap);
      boolean newLine = i > 0 && lexeme.firstOnLine();
      replace(end, gap, newLine ? lineEnds(gap) + " ".repeat(indent) : blanks);
      end = lexeme.end();
      if (lexeme.kind() == Kind.COMMENT) {
        end = end - blanksAtEnd(lexeme);
      }
    }
    String rest = text.substring(end);
    replace(end, rest, lexemes.size() == 0 ? "" : lineEnd);
  }

  private void replace(int start, String gap, String wanted) {
    if (!gap.equals(wanted) && !hasLoneReturn(gap)) {
      edits.add(TextEdit.replace(start, start + gap.length(), wanted));
    }
  }

  private String lineEnds(String gap) {
    long count = gap.chars().filter(found -> found == '\n').count();
    return lineEnd.repeat((int) Math.min(count, MAX_LINE_ENDS));
  }

  private int blanksAtEnd(Lexeme comment) {
    String words = text.substring(comment.start(), comment.end());
    return words.length() - words.stripTrailing().length();
  }

  /** A carriage return alone ends a comment but no line: such a place is better left alone. */
  private static boolean hasLoneReturn(String gap) {
    for (int i = gap.indexOf('\r'); i >= 0; i = gap.indexOf('\r', i + 1)) {
      if (!gap.startsWith("\n", i + 1)) {
        return true;
      }
    }
    return false;
  }
}
