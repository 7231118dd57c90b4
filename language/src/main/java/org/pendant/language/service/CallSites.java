package org.pendant.language.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;

/** Call sites: finds the calls of a text, in its order. */
final class CallSites {
  private final ScriptAnalysis analysis;
  private final List<CallSite> found = new ArrayList<>();

  private CallSites(ScriptAnalysis analysis) {
    this.analysis = analysis;
  }

  static List<CallSite> of(ScriptAnalysis analysis, Script script) {
    CallSites calls = new CallSites(analysis);
    calls.visit(script, OptionalInt.empty());
    return List.copyOf(calls.found);
  }

  private void visit(Node node, OptionalInt around) {
    OptionalInt caller =
        node instanceof Definition definition && !definition.name().isEmpty()
            ? OptionalInt.of(definition.nameRange().start())
            : around;
    switch (node) {
      case Expression.Call call ->
          note(call.nameRange(), call.range(), call.arguments(), signature(call), caller);
      case Expression.Run run ->
          note(run.nameRange(), run.range(), run.arguments(), signature(run), caller);
      case Expression.MethodCall call ->
          note(
              call.nameRange(),
              call.range(),
              call.arguments(),
              analysis.signatures().method(call.method()),
              caller);
      default -> {}
    }
    node.children().forEach(child -> visit(child, caller));
  }

  private Optional<Signature> signature(Expression.Call call) {
    return signature(call.function(), call.nameRange());
  }

  private Optional<Signature> signature(Expression.Run run) {
    return signature(run.thread(), run.nameRange());
  }

  private Optional<Signature> signature(String name, SourceRange nameRange) {
    FunctionScope scope = analysis.scopeAt(nameRange.start());
    return analysis.signatures().function(name, scope);
  }

  private void note(
      SourceRange nameRange,
      SourceRange range,
      List<Argument> arguments,
      Optional<Signature> signature,
      OptionalInt caller) {
    Optional<Occurrence> callee = analysis.index().at(nameRange.start());
    if (callee.isEmpty()) {
      return;
    }
    List<CallSite.Given> given = new ArrayList<>();
    for (int i = 0; i < arguments.size(); i++) {
      Argument argument = arguments.get(i);
      int position = i;
      Optional<Parameter> parameter =
          signature.flatMap(head -> parameter(head, argument, position));
      given.add(
          new CallSite.Given(argument.value().range(), argument.name().isPresent(), parameter));
    }
    found.add(new CallSite(callee.get().symbol(), nameRange, range, caller, given));
  }

  private static Optional<Parameter> parameter(Signature head, Argument argument, int position) {
    List<Parameter> parameters = head.parameters();
    if (argument.name().isPresent()) {
      return parameters.stream().filter(each -> each.named(argument.name().get())).findFirst();
    }
    return position < parameters.size() ? Optional.of(parameters.get(position)) : Optional.empty();
  }
}
