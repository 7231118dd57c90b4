package org.pendant.language.check;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.syntax.Expression;

/** The kind of an expression, without regard to what its variables hold. */
final class Inference {
  /** The one function of the language itself: its arguments name the members. */
  static final String STRUCT = "struct";

  private final Catalogue catalogue;

  Inference(Catalogue catalogue) {
    this.catalogue = catalogue;
  }

  Kind kind(Expression expression, FunctionScope scope) {
    return switch (expression) {
      case Expression.IntLiteral _, Expression.FloatLiteral _, Expression.Run _ -> Kind.NUMBER;
      case Expression.StringLiteral _ -> Kind.STRING;
      case Expression.BoolLiteral _ -> Kind.BOOL;
      case Expression.PoseLiteral _ -> Kind.POSE;
      case Expression.NoneLiteral _, Expression.Name _, Expression.Member _ -> Kind.ANY;
      case Expression.ListLiteral list -> {
        List<Kind> elements = new ArrayList<>();
        for (Expression element : list.elements()) {
          elements.add(kind(element, scope));
        }
        yield list(elements);
      }
      case Expression.Unary unary ->
          Operators.result(unary.operator(), kind(unary.operand(), scope));
      case Expression.Binary binary ->
          Operators.result(
              binary.operator(), kind(binary.left(), scope), kind(binary.right(), scope));
      case Expression.Call call -> call(call.function(), scope);
      case Expression.MethodCall call -> method(kind(call.receiver(), scope), call.method());
      case Expression.Index index -> index(kind(index.receiver(), scope), index.indices().size());
    };
  }

  /** A list of lists is a matrix. */
  static Kind list(List<Kind> elements) {
    Kind kind = elements.isEmpty() ? Kind.LIST : Kind.ANY;
    for (Kind element : elements) {
      if (element == Kind.LIST) {
        return Kind.MATRIX;
      }
      if (element.certain()) {
        kind = Kind.LIST;
      }
    }
    return kind;
  }

  static Kind index(Kind receiver, int indices) {
    boolean number = receiver == Kind.POSE || (receiver == Kind.MATRIX && indices == 2);
    return number ? Kind.NUMBER : Kind.ANY;
  }

  Kind method(Kind receiver, String name) {
    return switch (receiver) {
      case LIST, MATRIX, STRUCT ->
          catalogue
              .method(receiver.receiver(), name)
              .map(signature -> Kind.of(signature.result()))
              .orElse(Kind.ANY);
      case ANY, BOOL, NUMBER, STRING, POSE -> Kind.ANY;
    };
  }

  private Kind call(String name, FunctionScope scope) {
    if (scope.function(name).isPresent()) {
      return Kind.ANY;
    }
    if (name.equals(STRUCT)) {
      return Kind.STRUCT;
    }
    return catalogue.function(name).map(signature -> Kind.of(signature.result())).orElse(Kind.ANY);
  }
}
