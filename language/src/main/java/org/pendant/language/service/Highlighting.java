package org.pendant.language.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.Source;

/**
 * Highlighting: colours a text, right or wrong, fast enough to be asked at every keystroke.
 *
 * <p>It reads lexemes, not the tree: names are sorted by the definitions and assignments that are
 * written anywhere in the text, and by the parameters of the heads around them.
 */
public final class Highlighting {
  private final Lexemes lexemes;
  private final Catalogue catalogue;
  private final Map<String, Boolean> methods = new HashMap<>();
  private final Map<String, Boolean> builtins = new HashMap<>();
  private final Set<String> functions = new HashSet<>();
  private final Set<String> variables = new HashSet<>();
  private final Deque<Set<String>> parameters = new ArrayDeque<>();
  private final List<HighlightToken> tokens;

  private Highlighting(Lexemes lexemes, Catalogue catalogue) {
    this.lexemes = lexemes;
    this.catalogue = catalogue;
    this.tokens = new ArrayList<>(lexemes.size());
  }

  /** The coloured stretches of {@code source}, in order. */
  public static List<HighlightToken> of(Source source, Catalogue catalogue) {
    return of(Lexemes.of(source), catalogue);
  }

  static List<HighlightToken> of(Lexemes lexemes, Catalogue catalogue) {
    Highlighting highlighting = new Highlighting(lexemes, catalogue);
    highlighting.collectNames();
    for (int i = 0; i < lexemes.size(); i++) {
      highlighting.add(i);
    }
    return Collections.unmodifiableList(highlighting.tokens);
  }

  /** What the text defines and assigns, wherever it does. */
  private void collectNames() {
    int brackets = 0;
    for (int i = 0; i < lexemes.size(); i++) {
      Kind kind = lexemes.kind(i);
      switch (kind) {
        case OPEN -> brackets++;
        case CLOSE -> brackets = Math.max(0, brackets - 1);
        case OPENER, END, ALTERNATIVE -> brackets = 0;
        case NAME -> {
          if (lexemes.opensDefinition(i - 1)) {
            functions.add(lexemes.text(i));
          } else if (brackets == 0
              && lexemes.is(i + 1, Kind.ASSIGN)
              && !lexemes.is(i - 1, Kind.DOT)) {
            variables.add(lexemes.text(i));
          }
        }
        default -> {}
      }
    }
  }

  private void add(int index) {
    switch (lexemes.kind(index)) {
      case OPENER -> {
        parameters.push(lexemes.opensDefinition(index) ? headOf(index) : Set.of());
        add(index, Style.KEYWORD);
      }
      case END -> {
        parameters.poll();
        add(index, Style.KEYWORD);
      }
      case ALTERNATIVE, STATEMENT_WORD, OPERATOR_WORD, CONSTANT -> add(index, Style.KEYWORD);
      case NAME -> add(index, name(index));
      case NUMBER -> add(index, Style.NUMBER);
      case STRING -> add(index, Style.STRING);
      case LABEL -> add(index, Style.LABEL);
      case COMMENT -> add(index, Style.COMMENT);
      case ASSIGN, OPERATOR -> add(index, Style.OPERATOR);
      case FOREIGN -> add(index, foreign(index));
      case OPEN, CLOSE, COMMA, COLON, DOT -> {}
    }
  }

  private void add(int index, Style style) {
    Lexeme lexeme = lexemes.get(index);
    tokens.add(new HighlightToken(style, lexeme.start(), lexeme.end()));
  }

  /** A string that is still being typed is a string already. */
  private Style foreign(int index) {
    char first = lexemes.source().text().charAt(lexemes.get(index).start());
    return first == '"' ? Style.STRING : Style.UNKNOWN;
  }

  private Style name(int index) {
    String name = lexemes.text(index);
    if (lexemes.is(index - 1, Kind.DOT) && !lexemes.get(index).firstOnLine()) {
      return lexemes.reads(index + 1, "(") && isMethod(name) ? Style.BUILTIN : Style.MEMBER;
    }
    if (lexemes.opensDefinition(index - 1)) {
      return Style.FUNCTION;
    }
    if (lexemes.reads(index + 1, "(") && !lexemes.get(index + 1).firstOnLine()) {
      return callee(name);
    }
    boolean argument =
        lexemes.is(index + 1, Kind.ASSIGN)
            && (lexemes.is(index - 1, Kind.OPEN) || lexemes.is(index - 1, Kind.COMMA));
    if (argument || isParameter(name)) {
      return Style.PARAMETER;
    }
    if (name.equals("p") && lexemes.reads(index + 1, "[")) {
      return Style.KEYWORD;
    }
    return variables.contains(name) ? Style.VARIABLE : Style.UNKNOWN;
  }

  private boolean isMethod(String name) {
    return methods.computeIfAbsent(
        name,
        key ->
            catalogue.all().stream()
                .anyMatch(each -> each.receiver().isPresent() && each.name().equals(key)));
  }

  private Style callee(String name) {
    if (functions.contains(name)) {
      return Style.FUNCTION;
    }
    boolean builtin =
        name.equals(SymbolWalk.STRUCT)
            || builtins.computeIfAbsent(name, key -> catalogue.function(key).isPresent());
    return builtin ? Style.BUILTIN : Style.UNKNOWN;
  }

  /** Functions do not see what belongs to the function around them: the first head decides. */
  private boolean isParameter(String name) {
    for (Set<String> head : parameters) {
      if (!head.isEmpty()) {
        return head.contains(name);
      }
    }
    return false;
  }

  /** The parameters of a definition's head, and an empty name that marks it as one. */
  private Set<String> headOf(int opener) {
    Set<String> names = new HashSet<>(Set.of(""));
    if (!lexemes.reads(opener + 2, "(")) {
      return names;
    }
    int end = lexemes.close(opener + 2);
    int depth = 0;
    for (int i = opener + 2; i < end && !lexemes.is(i, Kind.COLON); i++) {
      Kind kind = lexemes.kind(i);
      depth += kind == Kind.OPEN ? 1 : kind == Kind.CLOSE ? -1 : 0;
      boolean begins = kind == Kind.OPEN || kind == Kind.COMMA;
      if (begins && depth == 1 && lexemes.is(i + 1, Kind.NAME)) {
        names.add(lexemes.text(i + 1));
      }
    }
    return names;
  }
}
