package org.pendant.language.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Source;

/**
 * Folding: finds what can be folded, from the lexemes alone: a broken statement unfolds nothing.
 */
final class Folding {
  private final Source source;
  private final List<FoldingRange> ranges = new ArrayList<>();
  private final Deque<Integer> openLines = new ArrayDeque<>();

  private Folding(Source source) {
    this.source = source;
  }

  static List<FoldingRange> of(Lexemes lexemes) {
    Folding folding = new Folding(lexemes.source());
    folding.blocks(lexemes);
    folding.comments(lexemes);
    folding.ranges.sort(Comparator.comparingInt(FoldingRange::startLine));
    return List.copyOf(folding.ranges);
  }

  private void blocks(Lexemes lexemes) {
    for (int i = 0; i < lexemes.size(); i++) {
      Lexeme lexeme = lexemes.get(i);
      int line = source.line(lexeme.start());
      if (lexeme.kind() == Kind.OPENER) {
        openLines.push(line);
      } else if (lexeme.kind() == Kind.END && !openLines.isEmpty()) {
        add(FoldingRange.Kind.BLOCK, openLines.pop(), line);
      } else if (lexeme.kind() == Kind.ALTERNATIVE && !openLines.isEmpty()) {
        add(FoldingRange.Kind.BLOCK, openLines.pop(), line - 1);
        openLines.push(line);
      }
    }
  }

  /** Comment lines directly below each other, without code on them. */
  private void comments(Lexemes lexemes) {
    int first = -1;
    int last = -1;
    for (int i = 0; i < lexemes.size(); i++) {
      Lexeme lexeme = lexemes.get(i);
      if (lexeme.kind() != Kind.COMMENT || !lexeme.firstOnLine()) {
        continue;
      }
      int line = source.line(lexeme.start());
      if (line != last + 1) {
        add(FoldingRange.Kind.COMMENT, first, last);
        first = line;
      }
      last = line;
    }
    add(FoldingRange.Kind.COMMENT, first, last);
  }

  private void add(FoldingRange.Kind kind, int start, int end) {
    if (end > start) {
      ranges.add(new FoldingRange(kind, start, end));
    }
  }
}
