package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Binding;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.ValueTypes;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.syntax.Statement.Definition;

/** Hover texts: what a hover shows about each kind of symbol. */
final class HoverTexts {
  private final ScriptAnalysis analysis;

  HoverTexts(ScriptAnalysis analysis) {
    this.analysis = analysis;
  }

  Hover of(Occurrence occurrence) {
    Symbol symbol = occurrence.symbol();
    return switch (symbol) {
      case Symbol.Global global -> variable(occurrence, "global " + global.name());
      case Symbol.Local local -> variable(occurrence, "local " + local.name());
      case Symbol.Parameter parameter -> parameter(occurrence, parameter);
      case Symbol.Function function -> function(occurrence, function);
      case Symbol.Builtin builtin ->
          analysis
              .signatures()
              .builtin(builtin.name())
              .map(signature -> builtin(occurrence, signature))
              .orElseGet(() -> bare(occurrence));
      case Symbol.Method method ->
          analysis
              .signatures()
              .method(method.name())
              .map(signature -> builtin(occurrence, signature))
              .orElseGet(() -> bare(occurrence));
      case Symbol.NamedArgument argument -> argument(occurrence, argument);
      case Symbol.Member member ->
          hover(occurrence, text("memberNamed", member.name()), List.of(), List.of());
      case Symbol.Unknown unknown ->
          hover(occurrence, unknown.name(), List.of(), List.of(text("undefinedName")));
    };
  }

  private Hover bare(Occurrence occurrence) {
    return hover(occurrence, occurrence.symbol().name(), List.of(), List.of());
  }

  private Hover builtin(Occurrence occurrence, Signature signature) {
    List<String> documentation = new ArrayList<>();
    documentation.add(signature.documentation());
    signature.parameters().forEach(parameter -> documentation.add(parameter.described()));
    List<String> facts = new ArrayList<>();
    if (signature.result() != Type.NONE) {
      facts.add(result(signature.result(), signature.resultUnit()));
    }
    if (!signature.deprecated().isEmpty()) {
      facts.add(text("deprecated", signature.deprecated()));
    }
    if (!signature.section().isEmpty()) {
      facts.add(text("manual", signature.section()));
    }
    return hover(occurrence, head(signature), documentation, facts);
  }

  private static String head(Signature signature) {
    return signature.receiver().map(type -> type.text() + ".").orElse("") + signature.head();
  }

  private Hover argument(Occurrence occurrence, Symbol.NamedArgument argument) {
    Optional<Parameter> parameter =
        analysis.signatures().builtin(argument.function()).stream()
            .flatMap(signature -> signature.parameters().stream())
            .filter(other -> other.name().equals(argument.name()))
            .findFirst();
    return hover(
        occurrence,
        text("parameterOf", argument.name(), argument.function()),
        parameter.map(Parameter::described).stream().toList(),
        List.of());
  }

  private static String result(Type type, Unit unit) {
    return unit == Unit.NONE
        ? text("result", type.text())
        : text("resultIn", type.text(), unit.symbol());
  }

  private Hover function(Occurrence occurrence, Symbol.Function function) {
    Definition definition = analysis.definitionAt(function.definedAt());
    Signature signature = analysis.signatures().of(definition);
    List<String> documentation =
        signature.documentation().isEmpty() ? List.of() : List.of(signature.documentation());
    return hover(
        occurrence,
        word(definition) + " " + signature.head(),
        documentation,
        List.of(text("definedOnLine", analysis.source().line(function.definedAt()))));
  }

  private static String word(Definition definition) {
    return switch (definition.kind()) {
      case FUNCTION -> "def";
      case SECONDARY -> "sec";
      case THREAD -> "thread";
    };
  }

  private Hover parameter(Occurrence occurrence, Symbol.Parameter parameter) {
    Definition definition = analysis.definitionAt(parameter.owner());
    List<String> lines =
        analysis.signatures().of(definition).parameters().stream()
            .filter(other -> other.name().equals(parameter.name()))
            .filter(other -> !other.required())
            .map(other -> text("defaultValue", other.defaultText()))
            .toList();
    return hover(
        occurrence, text("parameterOf", parameter.name(), definition.name()), List.of(), lines);
  }

  private Hover variable(Occurrence occurrence, String head) {
    List<String> lines = new ArrayList<>();
    Type type = type(occurrence);
    if (type != Type.ANY) {
      lines.add(text("holds", type.text()));
    }
    analysis
        .index()
        .origin(occurrence.symbol())
        .map(origin -> analysis.source().line(origin.range().start()))
        .ifPresent(line -> lines.add(text("firstAssignedOnLine", line)));
    return hover(occurrence, head, List.of(), lines);
  }

  private Type type(Occurrence occurrence) {
    ValueTypes types = analysis.types();
    String name = occurrence.symbol().name();
    FunctionScope scope = analysis.scopeAt(occurrence.range().start());
    Binding binding =
        occurrence.symbol() instanceof Symbol.Global
            ? new Binding.Global(name)
            : new Binding.Local(name);
    return types.variable(scope, binding);
  }

  private static Hover hover(
      Occurrence occurrence, String head, List<String> documentation, List<String> facts) {
    return new Hover(occurrence.range(), head, documentation, facts);
  }
}
