package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.Nearest;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.syntax.Statement.Definition;

/** Fixes for names that mean nothing, or not what they should. */
final class NameFixes {
  private final ScriptAnalysis analysis;
  private final Lexemes lexemes;
  private final FunctionScope scope;
  private final int start;
  private final int at;
  private final String name;

  private NameFixes(ScriptAnalysis analysis, int start, int at) {
    this.analysis = analysis;
    this.lexemes = analysis.lexemes();
    this.start = start;
    this.at = at;
    this.scope = analysis.scopeAt(start);
    this.name = lexemes.text(at);
  }

  static List<QuickFix> propose(ScriptAnalysis analysis, Diagnostic diagnostic) {
    int start = diagnostic.range().start();
    int at = analysis.lexemes().at(start);
    if (at < 0) {
      return List.of();
    }
    NameFixes fixes = new NameFixes(analysis, start, at);
    return switch (diagnostic.code()) {
      case "unknown-function" -> fixes.nearestFunction();
      case "unknown-variable" -> fixes.unknownVariable();
      case "unknown-argument" -> fixes.nearest(fixes.parameters());
      case "unknown-method" -> fixes.nearest(fixes.methods());
      case "deprecated" -> fixes.successor();
      case "no-effect" -> fixes.call();
      case "not-a-function" ->
          List.of(QuickFix.insert(text("startThread", fixes.name), start, "run "));
      case "not-a-thread" -> fixes.withoutRun();
      default -> List.of();
    };
  }

  private List<QuickFix> nearest(List<String> candidates) {
    return new Nearest().to(name, () -> candidates).stream().map(this::replace).toList();
  }

  private List<QuickFix> nearestFunction() {
    return new Nearest()
        .to(name, this::functions).stream()
            .map(
                found ->
                    scope.function(found).isPresent() ? found : analysis.catalogue().current(found))
            .map(this::replace)
            .toList();
  }

  private QuickFix replace(String with) {
    return QuickFix.replace(text("replaceBy", with), start, start + name.length(), with);
  }

  private List<String> functions() {
    List<String> names = new ArrayList<>();
    for (Definition definition : analysis.scopes().definitions()) {
      if (scope.function(definition.name()).isPresent()) {
        names.add(definition.name());
      }
    }
    analysis.signatures().builtins().forEach(signature -> names.add(signature.name()));
    return names;
  }

  private List<QuickFix> unknownVariable() {
    List<QuickFix> call = call();
    if (!call.isEmpty()) {
      return call;
    }
    List<String> names = new ArrayList<>(List.of("True", "False", "None"));
    names.addAll(scope.locals());
    names.addAll(scope.globals());
    return nearest(names);
  }

  private List<String> parameters() {
    return CallPlace.around(lexemes, start)
        .flatMap(analysis::callee)
        .map(signature -> signature.parameters().stream().map(Parameter::name).toList())
        .orElse(List.of());
  }

  private List<String> methods() {
    Receiver receiver = Receiver.of(analysis, lexemes.previous(at - 1), scope);
    return analysis.signatures().methods(receiver.type()).stream().map(Signature::name).toList();
  }

  /** A function without its brackets, if it can do without arguments. */
  private List<QuickFix> call() {
    boolean callable =
        analysis
            .signatures()
            .function(name, scope)
            .filter(signature -> signature.requiredCount() == 0)
            .isPresent();
    return callable
        ? List.of(QuickFix.insert(text("callIt", name), start + name.length(), "()"))
        : List.of();
  }

  private List<QuickFix> successor() {
    Optional<Signature> old = analysis.signatures().builtin(name);
    Optional<Signature> successor =
        old.flatMap(it -> analysis.catalogue().function(it.deprecated()));
    boolean agrees =
        successor.isPresent()
            && lexemes.reads(at + 1, "(")
            && takesTheSame(old.get(), successor.get());
    return agrees ? List.of(replace(successor.get().name())) : List.of();
  }

  /** Whether every call of {@code old} means the same when it calls {@code successor}. */
  private boolean takesTheSame(Signature old, Signature successor) {
    if (old.parameters().size() > successor.parameters().size()
        || old.requiredCount() != successor.requiredCount()) {
      return false;
    }
    for (int i = 0; i < old.parameters().size(); i++) {
      Parameter before = old.parameters().get(i);
      Parameter after = successor.parameters().get(i);
      boolean given = new CallPlace(at + 1, 0, at + 2).namesGiven(lexemes).contains(before.name());
      if (before.unit() != after.unit() || (given && !before.name().equals(after.name()))) {
        return false;
      }
    }
    return true;
  }

  private List<QuickFix> withoutRun() {
    return lexemes.is(at - 1, Kind.STATEMENT_WORD)
        ? List.of(QuickFix.replace(text("callWithoutRun"), lexemes.get(at - 1).start(), start, ""))
        : List.of();
  }
}
