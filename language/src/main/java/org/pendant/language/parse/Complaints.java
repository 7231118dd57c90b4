package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/** Syntax errors of one text, with the controller's wording beside ours. */
final class Complaints {
  /** More errors than this are no help; the rest is summed up in one. */
  static final int LIMIT = 50;

  /** A longer line is cut in the controller's wording: it has to fit into a message. */
  private static final int MAX_WIRE_LINE = 1000;

  private final Source source;
  private final List<Diagnostic> diagnostics = new ArrayList<>();
  private final Set<Integer> lines = new HashSet<>();
  private final List<Diagnostic> aboutMeaning = new ArrayList<>();
  private final List<SourceRange> places = new ArrayList<>();
  private boolean overflown;

  Complaints(Source source) {
    this.source = source;
  }

  /**
   * An error at {@code range}, where the controller's parser gives up too. One line is good for one
   * such error: two are seldom independent, and the first says enough.
   */
  void add(String code, SourceRange range, String message) {
    note(range);
    if (lines.add(source.line(range.start()))) {
      append(diagnostics, code, range, range.start(), message);
    }
  }

  /**
   * An error that the grammar allows; it says nothing new on a line with another error, nor around
   * another one that was found last.
   */
  void addAboutMeaning(String code, SourceRange range, String message) {
    note(range);
    if (aboutMeaning.isEmpty() || !holds(range, aboutMeaning.getLast().range())) {
      append(aboutMeaning, code, range, range.start(), message);
    }
  }

  private static boolean holds(SourceRange outer, SourceRange inner) {
    return outer.start() <= inner.start() && inner.end() <= outer.end();
  }

  /**
   * An error about a whole block, best shown at {@code range} though the controller notices it at
   * {@code gaveUpAt} only.
   */
  void addForBlock(String code, SourceRange range, int gaveUpAt, String message) {
    note(range);
    append(diagnostics, code, range, gaveUpAt, message);
  }

  /** Notes that the tokens at {@code range} are not read as they stand there. */
  void note(SourceRange range) {
    places.add(range);
  }

  /** All that was complained about or noted, also what was not worth telling. */
  List<SourceRange> places() {
    return places;
  }

  private void append(
      List<Diagnostic> list, String code, SourceRange range, int gaveUpAt, String message) {
    if (list.size() >= LIMIT) {
      overflown = true;
    } else {
      list.add(Diagnostic.error(code, range, message, wireText(gaveUpAt)));
    }
  }

  /** Forgets everything: the text is read again. */
  void clear() {
    diagnostics.clear();
    aboutMeaning.clear();
    lines.clear();
    places.clear();
    overflown = false;
  }

  /** The whole text cannot be read; the controller has no words for that. */
  void refuse(String code, String message) {
    diagnostics.add(Diagnostic.error(code, new SourceRange(0, 0), message, ""));
  }

  /** The text nests more deeply than the passes over it can follow. */
  void tooDeep(TokenPass.TooDeep found) {
    add("nested-too-deeply", found.token().range(), text(found.key(), found.limit()));
  }

  /** Whether there are so many that looking for more is of no use. */
  boolean full() {
    return overflown;
  }

  /** All of them in the order of the text. */
  List<Diagnostic> inOrder() {
    List<Diagnostic> ordered = new ArrayList<>(diagnostics);
    aboutMeaning.stream()
        .filter(diagnostic -> !lines.contains(source.line(diagnostic.range().start())))
        .forEach(ordered::add);
    ordered.sort((a, b) -> Integer.compare(a.range().start(), b.range().start()));
    if (overflown || ordered.size() > LIMIT) {
      ordered.subList(Math.min(LIMIT, ordered.size()), ordered.size()).clear();
      SourceRange last = ordered.getLast().range();
      ordered.add(
          Diagnostic.error(
              "too-many-errors",
              new SourceRange(last.end(), last.end()),
              text("tooManyErrors", LIMIT),
              ""));
    }
    return ordered;
  }

  private String wireText(int offset) {
    int line = source.line(offset);
    while (line > 1 && offset >= source.text().length() && source.lineText(line).isBlank()) {
      line--;
    }
    String text = source.lineText(line);
    String shown = text.length() > MAX_WIRE_LINE ? text.substring(0, MAX_WIRE_LINE) : text;
    return "syntax_error_on_line:" + line + ":" + shown + ":";
  }
}
