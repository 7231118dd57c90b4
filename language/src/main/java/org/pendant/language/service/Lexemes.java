package org.pendant.language.service;

import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.parse.LexemeReader;
import org.pendant.language.parse.LexemeTable;
import org.pendant.language.source.Source;

/** The lexemes of one text, found by offset and read as words. */
final class Lexemes {
  private final Source source;
  private final LexemeTable lexemes;

  private Lexemes(Source source, LexemeTable lexemes) {
    this.source = source;
    this.lexemes = lexemes;
  }

  static Lexemes of(Source source) {
    return of(source, LexemeReader.lexemes(source));
  }

  /** Of a text that has been read. */
  static Lexemes of(Source source, LexemeTable lexemes) {
    return new Lexemes(source, lexemes);
  }

  Source source() {
    return source;
  }

  int size() {
    return lexemes.size();
  }

  Lexeme get(int index) {
    return lexemes.get(index);
  }

  /** The kind of lexeme {@code index}; that of a comment outside the text, which means nothing. */
  Kind kind(int index) {
    return index >= 0 && index < lexemes.size() ? lexemes.kind(index) : Kind.COMMENT;
  }

  boolean is(int index, Kind kind) {
    return index >= 0 && index < lexemes.size() && lexemes.kind(index) == kind;
  }

  /** Whether lexeme {@code index} exists and reads {@code text}. */
  boolean reads(int index, String text) {
    if (index < 0 || index >= lexemes.size()) {
      return false;
    }
    int start = lexemes.start(index);
    return lexemes.end(index) - start == text.length() && source.text().startsWith(text, start);
  }

  String text(int index) {
    return source.text().substring(lexemes.start(index), lexemes.end(index));
  }

  /** The first byte of lexeme {@code index}. */
  int initial(int index) {
    return source.text().charAt(lexemes.start(index));
  }

  /** The last lexeme that begins before {@code offset}, or -1. */
  int before(int offset) {
    return lexemes.indexAt(offset) - 1;
  }

  /** The lexeme that begins at {@code offset} or holds it, or -1. */
  int at(int offset) {
    int index = before(offset + 1);
    return index >= 0 && lexemes.end(index) > offset ? index : -1;
  }

  /** The nearest lexeme before {@code index} that is no comment, or -1. */
  int previous(int index) {
    int at = index - 1;
    while (at >= 0 && lexemes.kind(at) == Kind.COMMENT) {
      at--;
    }
    return at;
  }

  /** The bracket that closes {@code opener}; the size if none does. */
  int close(int opener) {
    int depth = 0;
    for (int i = opener; i < lexemes.size(); i++) {
      switch (lexemes.kind(i)) {
        case OPEN -> depth++;
        case CLOSE -> {
          if (--depth == 0) {
            return i;
          }
        }
        case OPENER, END, ALTERNATIVE -> {
          return lexemes.size();
        }
        default -> {}
      }
    }
    return lexemes.size();
  }

  /** The bracket that {@code closer} closes, or -1. */
  int open(int closer) {
    int depth = 0;
    for (int i = closer; i >= 0; i--) {
      switch (lexemes.kind(i)) {
        case CLOSE -> depth++;
        case OPEN -> {
          if (--depth == 0) {
            return i;
          }
        }
        case OPENER, END, ALTERNATIVE -> {
          return -1;
        }
        default -> {}
      }
    }
    return -1;
  }

  /** Whether this word opens a definition. */
  boolean opensDefinition(int index) {
    return is(index, Kind.OPENER) && !reads(index, "if") && !reads(index, "while");
  }
}
