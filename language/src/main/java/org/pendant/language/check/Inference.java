package org.pendant.language.check;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.syntax.Expression;

/** Kind inference: the kind of an expression, without regard to the values of its variables. */
final class Inference {
  /** The one function of the language itself: its arguments name the members. */
  static final String STRUCT = "struct";

  private final Catalogue catalogue;

  Inference(Catalogue catalogue) {
    this.catalogue = catalogue;
  }

  StaticType kind(Expression expression, FunctionScope scope) {
    return switch (expression) {
      case Expression.IntLiteral _, Expression.FloatLiteral _, Expression.Run _ ->
          StaticType.NUMBER;
      case Expression.StringLiteral _ -> StaticType.STRING;
      case Expression.BoolLiteral _ -> StaticType.BOOL;
      case Expression.PoseLiteral _ -> StaticType.POSE;
      case Expression.NoneLiteral _, Expression.Name _, Expression.Member _ -> StaticType.ANY;
      case Expression.ListLiteral list -> {
        List<StaticType> elements = new ArrayList<>();
        for (Expression element : list.elements()) {
          elements.add(kind(element, scope));
        }
        yield list(elements);
      }
      case Expression.Unary unary ->
          OperatorTypes.result(unary.operator(), kind(unary.operand(), scope));
      case Expression.Binary binary ->
          OperatorTypes.result(
              binary.operator(), kind(binary.left(), scope), kind(binary.right(), scope));
      case Expression.Call call -> call(call.function(), scope);
      case Expression.MethodCall call -> method(kind(call.receiver(), scope), call.method());
      case Expression.Index index -> index(kind(index.receiver(), scope), index.indices().size());
    };
  }

  /** A list of lists is a matrix. */
  static StaticType list(List<StaticType> elements) {
    StaticType kind = elements.isEmpty() ? StaticType.LIST : StaticType.ANY;
    for (StaticType element : elements) {
      if (element == StaticType.LIST) {
        return StaticType.MATRIX;
      }
      if (element.certain()) {
        kind = StaticType.LIST;
      }
    }
    return kind;
  }

  static StaticType index(StaticType receiver, int indices) {
    boolean number = receiver == StaticType.POSE || (receiver == StaticType.MATRIX && indices == 2);
    return number ? StaticType.NUMBER : StaticType.ANY;
  }

  StaticType method(StaticType receiver, String name) {
    return switch (receiver) {
      case LIST, MATRIX, STRUCT ->
          catalogue
              .method(receiver.receiver(), name)
              .map(signature -> StaticType.of(signature.result()))
              .orElse(StaticType.ANY);
      case ANY, BOOL, NUMBER, STRING, POSE -> StaticType.ANY;
    };
  }

  private StaticType call(String name, FunctionScope scope) {
    if (scope.function(name).isPresent()) {
      return StaticType.ANY;
    }
    if (name.equals(STRUCT)) {
      return StaticType.STRUCT;
    }
    return catalogue
        .function(name)
        .map(signature -> StaticType.of(signature.result()))
        .orElse(StaticType.ANY);
  }
}
