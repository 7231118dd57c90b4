package org.pendant.sweep.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;

/** Script places: where in the text of a program stands what the parameters of a plan change. */
final class ScriptPlaces {
  private static final Set<String> MOVES = Set.of("movej", "movel", "movep", "movec");

  private final Source source;
  private final Catalogue catalogue;
  private final Map<String, Expression> firstValues = new LinkedHashMap<>();
  private final List<Expression.Call> calls = new ArrayList<>();

  ScriptPlaces(Script script, Catalogue catalogue) {
    source = script.source();
    this.catalogue = catalogue;
    script.statements().forEach(this::look);
  }

  private void look(Node node) {
    switch (node) {
      case Statement.Assign assign when assign.target() instanceof Expression.Name variable ->
          firstValues.putIfAbsent(variable.name(), assign.value());
      case ParameterDeclaration parameter ->
          parameter
              .defaultValue()
              .ifPresent(value -> firstValues.putIfAbsent(parameter.name(), value));
      case Expression.Call call -> calls.add(call);
      default -> {}
    }
    node.children().forEach(this::look);
  }

  /** The value that a variable is assigned first. */
  Optional<Expression> firstValue(String variable) {
    return Optional.ofNullable(firstValues.get(variable));
  }

  /** The names of all variables that are assigned, in the order of the text. */
  Set<String> variables() {
    return firstValues.keySet();
  }

  /** Element {@code index} of the list or pose that a variable is assigned first. */
  Optional<Expression> firstElement(String variable, int index) {
    return firstValue(variable)
        .flatMap(
            value ->
                switch (value) {
                  case Expression.PoseLiteral(var elements, var _) -> element(elements, index);
                  case Expression.ListLiteral(var elements, var _) -> element(elements, index);
                  default -> Optional.empty();
                });
  }

  private static Optional<Expression> element(List<Expression> elements, int index) {
    return index < elements.size() ? Optional.of(elements.get(index)) : Optional.empty();
  }

  /** The outermost call that begins in a line, from 1. */
  Optional<Expression.Call> callIn(int line) {
    return calls.stream().filter(each -> source.line(each.range().start()) == line).findFirst();
  }

  /** All calls, in the order of the text. */
  List<Expression.Call> calls() {
    return List.copyOf(calls);
  }

  /** All moves. */
  List<Expression.Call> moves() {
    return calls.stream().filter(each -> MOVES.contains(each.function())).toList();
  }

  /** The parameter of a built-in function that a call names. */
  Optional<Parameter> parameter(Expression.Call call, String name) {
    return catalogue
        .function(call.function())
        .flatMap(
            signature ->
                signature.parameters().stream().filter(each -> each.named(name)).findFirst());
  }

  /** What a call gives a parameter; empty where it leaves that out. */
  Optional<Expression> given(Expression.Call call, Parameter parameter) {
    Signature signature = catalogue.function(call.function()).orElseThrow();
    List<Argument> arguments = call.arguments();
    for (int i = 0; i < arguments.size(); i++) {
      Argument each = arguments.get(i);
      boolean meant =
          each.name().isPresent()
              ? parameter.named(each.name().get())
              : signature.parameters().indexOf(parameter) == i;
      if (meant) {
        return Optional.of(each.value());
      }
    }
    return Optional.empty();
  }

  /** Gives a parameter of a call another value. */
  void give(TextChanges changes, Expression.Call call, Parameter parameter, String value) {
    Optional<Expression> given = given(call, parameter);
    if (given.isPresent()) {
      changes.replace(given.get().range(), value);
    } else {
      changes.insert(call.range().end() - 1, ", " + parameter.name() + "=" + value);
    }
  }

  /** Multiplies what all moves give a parameter, or its default where they give nothing. */
  void scaleMoves(TextChanges changes, String name, String factor) {
    for (Expression.Call call : moves()) {
      Optional<Parameter> parameter = parameter(call, name);
      if (parameter.isEmpty()) {
        continue;
      }
      Optional<Expression> given = given(call, parameter.get());
      if (given.isPresent()) {
        changes.wrap(given.get().range(), "(", ")*" + factor);
      } else if (!parameter.get().required()) {
        changes.insert(
            call.range().end() - 1,
            ", " + name + "=" + parameter.get().defaultText() + "*" + factor);
      }
    }
  }
}
