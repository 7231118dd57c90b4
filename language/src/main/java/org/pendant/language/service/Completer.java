package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;

/** Completer: collects, filters and orders what may be typed at one place. */
final class Completer {
  private final ScriptAnalysis analysis;
  private final Lexemes lexemes;
  private final CompletionPlace place;
  private final FunctionScope scope;
  private final boolean parenthesised;
  private final List<Offer> found = new ArrayList<>();
  private final Set<String> offered = new HashSet<>();

  /**
   * What is offered, and how near it is.
   *
   * @param name counts by how often the text has it; empty where that means nothing
   * @param rank of one that the text does not have, among those of its kind, the least first
   */
  private record Offer(Completion completion, Matching matching, String name, int rank) {
    /** What the text has most often comes first. */
    int rank(Map<String, Integer> uses) {
      int used = uses.getOrDefault(name, 0);
      return used > 0 ? -used : rank;
    }
  }

  private Completer(ScriptAnalysis analysis, int offset) {
    this.analysis = analysis;
    this.lexemes = analysis.lexemes();
    this.place = CompletionPlace.at(lexemes, offset);
    this.scope = analysis.scopeAt(offset);
    this.parenthesised = analysis.source().text().startsWith("(", place.word().end());
  }

  static List<Completion> complete(ScriptAnalysis analysis, int offset) {
    Completer completer = new Completer(analysis, offset);
    completer.collect();
    Map<String, Integer> uses = completer.uses();
    return completer.found.stream()
        .sorted(
            Comparator.comparing(Offer::matching)
                .thenComparing(offer -> offer.completion().kind())
                .thenComparingInt(offer -> offer.rank(uses))
                .thenComparing(offer -> offer.completion().label()))
        .map(Offer::completion)
        .toList();
  }

  /** How often the text has each name that is offered. */
  private Map<String, Integer> uses() {
    Set<String> names = new HashSet<>();
    boolean[] initials = new boolean[256];
    for (Offer offer : found) {
      if (!offer.name().isEmpty()) {
        names.add(offer.name());
        initials[offer.name().charAt(0) & 0xFF] = true;
      }
    }
    Map<String, Integer> uses = new HashMap<>();
    for (int i = 0; i < lexemes.size() && !names.isEmpty(); i++) {
      // Nearly all words begin with another letter than what is typed.
      if (lexemes.is(i, Kind.NAME) && initials[lexemes.initial(i)]) {
        String word = lexemes.text(i);
        if (names.contains(word)) {
          uses.merge(word, 1, Integer::sum);
        }
      }
    }
    return uses;
  }

  private void collect() {
    switch (place.role()) {
      case NOTHING -> {}
      case OPERATOR -> keywords(Keywords.operators());
      case GLOBAL -> scope.globals().forEach(name -> name(Completion.Kind.GLOBAL, name));
      case THREAD -> definitions(true);
      case MEMBER -> members();
      case STATEMENT -> {
        variables();
        definitions(false);
        keywords(Keywords.statements(lexemes, place.word().start()));
        builtins();
      }
      case VALUE -> {
        place.call().ifPresent(this::argumentNames);
        variables();
        definitions(false);
        keywords(Keywords.values());
        builtins();
      }
    }
  }

  private void variables() {
    Set<String> parameters = new HashSet<>();
    scope
        .definition()
        .ifPresent(
            owner -> owner.parameters().forEach(parameter -> parameters.add(parameter.name())));
    for (String local : scope.locals()) {
      boolean parameter = parameters.contains(local);
      name(parameter ? Completion.Kind.PARAMETER : Completion.Kind.LOCAL, local);
    }
    Set<String> locals = Set.copyOf(scope.locals());
    scope.globals().stream()
        .filter(name -> !locals.contains(name))
        .forEach(name -> name(Completion.Kind.GLOBAL, name));
  }

  /** Threads where they are started; functions and secondary programs where values stand. */
  private void definitions(boolean threads) {
    for (Definition definition : analysis.scopes().definitions()) {
      if (!matches(definition.name())) {
        continue;
      }
      boolean thread = definition.kind() == DefinitionKind.THREAD;
      boolean visible =
          scope.function(definition.name()).filter(other -> isSame(other, definition)).isPresent();
      if (thread == threads && visible && !definition.name().isEmpty()) {
        call(
            thread ? Completion.Kind.THREAD : Completion.Kind.FUNCTION,
            analysis.signatures().of(definition));
      }
    }
  }

  /** Not equals: two definitions with the same text are still two. */
  private static boolean isSame(Definition one, Definition other) {
    return one.range().equals(other.range());
  }

  private void builtins() {
    for (Signature signature : analysis.signatures().builtins()) {
      if (scope.function(signature.name()).isEmpty()) {
        call(Completion.Kind.BUILTIN, signature);
      }
    }
  }

  private void keywords(List<Keywords.Offer> offers) {
    List<Keywords.Offer> fitting = offers.stream().filter(each -> matches(each.label())).toList();
    // To know how lines end takes a look at all of them.
    String newLine =
        fitting.stream().anyMatch(Keywords.Offer::isSnippet)
            ? analysis.lineEnd() + analysis.indentationAt(place.word().start())
            : "";
    for (Keywords.Offer offer : fitting) {
      offer(
          offer.isSnippet() ? Completion.Kind.SNIPPET : Completion.Kind.KEYWORD,
          offer.label(),
          offer.description(),
          "",
          offer.pattern().replace("\n", newLine),
          List.of(),
          "",
          0);
    }
  }

  private void argumentNames(CallPlace call) {
    Set<String> given = call.namesGiven(lexemes);
    Optional<Signature> signature = analysis.callee(call);
    if (signature.isEmpty()) {
      return;
    }
    List<Parameter> parameters = signature.get().parameters();
    for (int i = call.position(); i < parameters.size(); i++) {
      Parameter parameter = parameters.get(i);
      if (!given.contains(parameter.name())) {
        offer(
            Completion.Kind.ARGUMENT,
            parameter.name() + "=",
            parameter.described(),
            "",
            parameter.name() + "=" + Keywords.CARET,
            List.of(),
            "",
            i);
      }
    }
  }

  /** Members and methods of what stands before the dot. */
  private void members() {
    int receiver = lexemes.previous(place.previous());
    Receiver known = Receiver.of(analysis, receiver, scope);
    List<String> members =
        known.type() == Type.ANY && known.members().isEmpty()
            ? analysis.index().members()
            : List.copyOf(known.members());
    for (String member : members) {
      // What is being typed may itself have been read as a member.
      if (!member.equals(place.prefix())) {
        name(Completion.Kind.MEMBER, member);
      }
    }
    analysis
        .signatures()
        .methods(known.type())
        .forEach(signature -> call(Completion.Kind.METHOD, signature));
  }

  private void name(Completion.Kind kind, String name) {
    offer(kind, name, "", "", name + Keywords.CARET, List.of(), name, 0);
  }

  private void call(Completion.Kind kind, Signature signature) {
    String name = signature.name();
    if (!matches(name)) {
      return;
    }
    boolean empty = signature.parameters().isEmpty() && !name.equals(SymbolWalk.STRUCT);
    String pattern = parenthesised ? name + "|" : empty ? name + "()|" : name + "(|)";
    List<String> arguments =
        parenthesised
            ? List.of()
            : signature.parameters().stream()
                .filter(Parameter::required)
                .map(Parameter::name)
                .toList();
    offer(
        kind,
        name,
        detail(signature),
        firstSentence(signature.documentation()),
        pattern,
        arguments,
        name,
        kind == Completion.Kind.BUILTIN ? commonRank(signature) : 0);
  }

  private boolean matches(String name) {
    return Matching.of(place.prefix(), name) != Matching.NONE;
  }

  /** What other programs call most comes first, deprecated functions last. */
  private static int commonRank(Signature signature) {
    return signature.deprecated().isEmpty()
        ? CommonFunctions.rank(signature.name())
        : Integer.MAX_VALUE;
  }

  /** The head with the units of its parameters: {@code (q, a=1.4 rad/s², ...)}. */
  private static String detail(Signature signature) {
    StringBuilder detail = new StringBuilder("(");
    String separator = "";
    for (Parameter parameter : signature.parameters()) {
      detail.append(separator).append(parameter.name());
      if (!parameter.required()) {
        detail.append('=').append(parameter.defaultText());
      }
      if (parameter.unit() != Unit.NONE) {
        detail.append(' ').append(parameter.unit().symbol());
      }
      separator = ", ";
    }
    return detail.append(')').toString();
  }

  private static String firstSentence(String text) {
    int end = text.indexOf(". ");
    String sentence = end < 0 ? text : text.substring(0, end + 1);
    return sentence.replace('\n', ' ');
  }

  private void offer(
      Completion.Kind kind,
      String label,
      String detail,
      String documentation,
      String pattern,
      List<String> arguments,
      String counted,
      int rank) {
    Matching matching = Matching.of(place.prefix(), label);
    if (matching == Matching.NONE || !offered.add(kind + label)) {
      return;
    }
    int caret = pattern.indexOf(Keywords.CARET);
    String insert = pattern.substring(0, caret) + pattern.substring(caret + 1);
    found.add(
        new Offer(
            new Completion(
                kind, label, detail, documentation, place.word(), insert, caret, arguments),
            matching,
            counted,
            rank));
  }
}
