package org.pendant.language.check;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;

/** Checks definitions: their heads, then their bodies. */
final class DefinitionCheck {
  private final CheckRun run;

  DefinitionCheck(CheckRun run) {
    this.run = run;
  }

  /**
   * Checks a definition that is not the program itself.
   *
   * @param defined the names already defined beside it; its own is added
   */
  void check(Definition definition, FunctionScope scope, Set<String> defined) {
    head(definition, scope, defined);
    FunctionState state = new FunctionState(scope, run.graph().node(definition));
    new StatementCheck(run, state).block(definition.body());
  }

  /** Checks the name and the parameters alone. */
  void head(Definition definition, FunctionScope scope, Set<String> defined) {
    String name = definition.name();
    if (!defined.add(name)) {
      error("duplicate-definition", definition.nameRange(), name + " is defined twice here");
    } else if (run.builtin(name).isPresent()) {
      run.findings()
          .warning(
              "hides-builtin",
              definition.nameRange(),
              name + " is also a built-in function, which this definition hides");
    }
    Set<String> names = new HashSet<>();
    for (ParameterDeclaration parameter : definition.parameters()) {
      if (!names.add(parameter.name())) {
        error(
            "duplicate-parameter",
            parameter.range(),
            name + " has two parameters " + parameter.name());
      }
      parameter.defaultValue().ifPresent(value -> defaultValue(value, scope));
    }
  }

  private void defaultValue(Expression value, FunctionScope scope) {
    if (constant(value, scope)) {
      CallGraph.Node nowhere = new CallGraph.Node();
      new ExpressionCheck(run, new FunctionState(scope, nowhere)).check(value);
    }
  }

  /** Whether the value is the same at every call; complains if not. */
  private boolean constant(Expression value, FunctionScope scope) {
    return switch (value) {
      case Expression.IntLiteral _,
          Expression.FloatLiteral _,
          Expression.StringLiteral _,
          Expression.BoolLiteral _,
          Expression.NoneLiteral _ ->
          true;
      case Expression.PoseLiteral pose -> allConstant(pose.elements(), scope);
      case Expression.ListLiteral list -> allConstant(list.elements(), scope);
      case Expression.Unary unary -> constant(unary.operand(), scope);
      case Expression.Binary binary ->
          constant(binary.left(), scope) && constant(binary.right(), scope);
      case Expression.Index index ->
          constant(index.receiver(), scope) && allConstant(index.indices(), scope);
      case Expression.Call call when constantFunction(call.function(), scope) ->
          allConstant(call.arguments().stream().map(Argument::value).toList(), scope);
      case Expression.Name(String name, SourceRange range) -> notConstant(range, name);
      case Expression.Call call -> notConstant(call.nameRange(), call.function() + "()");
      case Expression.MethodCall call -> notConstant(call.nameRange(), call.method() + "()");
      case Expression.Member member -> notConstant(member.nameRange(), member.member());
      case Expression.Run start -> notConstant(start.range(), "run");
    };
  }

  private boolean allConstant(List<Expression> values, FunctionScope scope) {
    for (Expression value : values) {
      if (!constant(value, scope)) {
        return false;
      }
    }
    return true;
  }

  private boolean constantFunction(String name, FunctionScope scope) {
    if (scope.function(name).isPresent()) {
      return false;
    }
    return name.equals(Inference.STRUCT)
        || run.builtin(name).filter(found -> !found.signature().physicalTime()).isPresent();
  }

  private boolean notConstant(SourceRange range, String what) {
    error(
        "default-not-constant",
        range,
        what + " in a default value may change; expected a constant expression");
    return false;
  }

  private void error(String code, SourceRange range, String message) {
    run.findings().error(code, range, message);
  }
}
