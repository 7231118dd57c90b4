package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/**
 * Partial check: what is certainly wrong in a text of which parts cannot be read. What the checker
 * says of the rest counts where no part that is missing could make it right.
 */
final class PartialCheck {
  private static final String TEMPLATE = "template";

  /** What is wrong whatever the statements say that could not be read. */
  private static final Set<String> CERTAIN =
      Set.of(
          "deprecated",
          "duplicate-argument",
          "missing-argument",
          "positional-after-named",
          "too-many-arguments",
          "unknown-argument");

  /** What is wrong unless a statement that could not be read gives the name a meaning. */
  private static final Set<String> OF_NAMES = Set.of("unknown-function", "unknown-variable");

  private final Source source;
  private final Lexemes lexemes;
  private final Set<Integer> unreadLines = new HashSet<>();
  private final Set<String> given = new HashSet<>();

  private PartialCheck(Lexemes lexemes, List<Diagnostic> syntax) {
    this.lexemes = lexemes;
    source = lexemes.source();
    for (Diagnostic each : syntax) {
      int last = source.line(each.range().end());
      for (int line = source.line(each.range().start()); line <= last; line++) {
        unreadLines.add(line);
      }
    }
    boolean inHead = false;
    for (int i = 0; i < lexemes.size(); i++) {
      if (lexemes.get(i).firstOnLine()) {
        inHead = lexemes.opensDefinition(i);
      }
      if (lexemes.is(i, Kind.NAME) && (inHead || mayBeAssigned(i))) {
        given.add(lexemes.text(i));
      }
    }
  }

  /**
   * Syntax errors and what is certain besides, in the order of the text.
   *
   * @param syntax what the parser says, with an error
   * @param found what the checker says of the statements that could be read
   */
  static List<Diagnostic> of(Lexemes lexemes, List<Diagnostic> syntax, List<Diagnostic> found) {
    if (syntax.stream().anyMatch(each -> each.code().equals(TEMPLATE))) {
      return syntax;
    }
    PartialCheck check = new PartialCheck(lexemes, syntax);
    List<Diagnostic> all = new ArrayList<>(syntax);
    found.stream().filter(check::isCertain).forEach(all::add);
    all.sort(Comparator.comparingInt(each -> each.range().start()));
    return List.copyOf(all);
  }

  private boolean isCertain(Diagnostic found) {
    if (unreadLines.contains(source.line(found.range().start()))) {
      return false;
    }
    return CERTAIN.contains(found.code())
        || (OF_NAMES.contains(found.code()) && !given.contains(source.text(found.range())));
  }

  /** Whether a name stands before a sign that gives it a value, or behind a word such as global. */
  private boolean mayBeAssigned(int index) {
    return lexemes.is(index + 1, Kind.ASSIGN) || lexemes.is(index - 1, Kind.STATEMENT_WORD);
  }
}
