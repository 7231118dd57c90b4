package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.Binding;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.Scopes;
import org.pendant.language.service.Occurrence.Role;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;

/** Symbol walk: visits every name of a program and notes what it stands for. */
final class SymbolWalk {
  /** The one function that belongs to the language itself. */
  static final String STRUCT = "struct";

  private final Scopes scopes;
  private final Catalogue catalogue;
  private final List<Occurrence> found = new ArrayList<>();
  private final Map<Symbol, Set<String>> members = new HashMap<>();
  private final Map<FunctionScope, Set<String>> locals = new HashMap<>();
  private final Map<String, Boolean> builtins = new HashMap<>();

  SymbolWalk(Scopes scopes, Catalogue catalogue) {
    this.scopes = scopes;
    this.catalogue = catalogue;
  }

  /** All occurrences so far, in the order of the text. */
  List<Occurrence> found() {
    found.sort(Comparator.comparingInt(occurrence -> occurrence.range().start()));
    return List.copyOf(found);
  }

  /** The members of the structs that each variable was assigned as a literal. */
  Map<Symbol, Set<String>> members() {
    return members;
  }

  void statements(List<Statement> statements, FunctionScope scope) {
    for (Statement statement : statements) {
      statement(statement, scope);
    }
  }

  private void statement(Statement statement, FunctionScope scope) {
    switch (statement) {
      case Statement.Assign assign -> assign(assign, scope);
      case Statement.Evaluate evaluate -> expression(evaluate.expression(), scope);
      case Statement.If choice -> {
        for (Statement.Branch branch : choice.branches()) {
          expression(branch.condition(), scope);
          statements(branch.body(), scope);
        }
        choice.otherwise().ifPresent(body -> statements(body, scope));
      }
      case Statement.While loop -> {
        expression(loop.condition(), scope);
        statements(loop.body(), scope);
      }
      case Statement.Return back -> back.value().ifPresent(value -> expression(value, scope));
      case Statement.Join join -> expression(join.handle(), scope);
      case Statement.Kill kill -> expression(kill.handle(), scope);
      case Definition definition -> definition(definition);
      case Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.EnterCritical _,
          Statement.ExitCritical _,
          Statement.Label _ -> {}
    }
  }

  private void definition(Definition definition) {
    FunctionScope scope = scopes.scope(definition);
    if (!definition.name().isEmpty()) {
      note(function(definition), definition.nameRange(), Role.DECLARE);
    }
    for (ParameterDeclaration parameter : definition.parameters()) {
      note(
          parameter(definition, parameter.name()),
          head(parameter.range(), parameter.name()),
          Role.DECLARE);
      parameter.defaultValue().ifPresent(value -> expression(value, scope));
    }
    statements(definition.body(), scope);
  }

  private void assign(Statement.Assign assign, FunctionScope scope) {
    if (assign.target() instanceof Expression.Name name) {
      Symbol symbol = variable(scope.target(assign), scope);
      note(symbol, name.range(), Role.WRITE);
      if (assign.value() instanceof Expression.Call call && call.function().equals(STRUCT)) {
        Set<String> names = members.computeIfAbsent(symbol, _ -> new LinkedHashSet<>());
        call.arguments().forEach(argument -> argument.name().ifPresent(names::add));
      }
    } else {
      expression(assign.target(), scope);
    }
    expression(assign.value(), scope);
  }

  private void expression(Expression expression, FunctionScope scope) {
    switch (expression) {
      case Expression.Name name ->
          note(
              variable(scope.resolve(name.name(), name.range().start()), scope),
              name.range(),
              Role.USE);
      case Expression.PoseLiteral pose -> expressions(pose.elements(), scope);
      case Expression.ListLiteral list -> expressions(list.elements(), scope);
      case Expression.Unary unary -> expression(unary.operand(), scope);
      case Expression.Binary binary -> {
        expression(binary.left(), scope);
        expression(binary.right(), scope);
      }
      case Expression.Index index -> {
        expression(index.receiver(), scope);
        expressions(index.indices(), scope);
      }
      case Expression.Member member -> {
        expression(member.receiver(), scope);
        note(new Symbol.Member(member.member()), member.nameRange(), Role.USE);
      }
      case Expression.MethodCall call -> {
        expression(call.receiver(), scope);
        note(new Symbol.Method(call.method()), call.nameRange(), Role.USE);
        call.arguments().forEach(argument -> expression(argument.value(), scope));
      }
      case Expression.Call call -> {
        note(callee(call.function(), scope), call.nameRange(), Role.USE);
        arguments(call, scope);
      }
      case Expression.Run run -> {
        note(callee(run.thread(), scope), run.nameRange(), Role.USE);
        run.arguments().forEach(argument -> expression(argument.value(), scope));
      }
      case Expression.IntLiteral _,
          Expression.FloatLiteral _,
          Expression.StringLiteral _,
          Expression.BoolLiteral _,
          Expression.NoneLiteral _ -> {}
    }
  }

  private void expressions(List<Expression> expressions, FunctionScope scope) {
    for (Expression expression : expressions) {
      expression(expression, scope);
    }
  }

  private void arguments(Expression.Call call, FunctionScope scope) {
    for (Argument argument : call.arguments()) {
      if (argument.name().isPresent()) {
        String name = argument.name().get();
        note(argumentName(call.function(), name, scope), head(argument.range(), name), Role.USE);
      }
      expression(argument.value(), scope);
    }
  }

  private Symbol argumentName(String function, String name, FunctionScope scope) {
    Optional<Definition> defined = scope.function(function);
    if (defined.isPresent()) {
      boolean declared =
          defined.get().parameters().stream().anyMatch(other -> other.name().equals(name));
      return declared ? parameter(defined.get(), name) : new Symbol.Unknown(name);
    }
    return function.equals(STRUCT)
        ? new Symbol.Member(name)
        : new Symbol.NamedArgument(function, name);
  }

  private Symbol callee(String name, FunctionScope scope) {
    Optional<Definition> defined = scope.function(name);
    if (defined.isPresent()) {
      return function(defined.get());
    }
    boolean builtin =
        name.equals(STRUCT)
            || builtins.computeIfAbsent(name, key -> catalogue.function(key).isPresent());
    return builtin ? new Symbol.Builtin(name) : new Symbol.Unknown(name);
  }

  private static Symbol function(Definition definition) {
    return new Symbol.Function(definition.name(), definition.nameRange().start());
  }

  private Symbol parameter(Definition definition, String name) {
    return scopes.scope(definition).mainLevel()
        ? new Symbol.Global(name)
        : new Symbol.Parameter(name, definition.nameRange().start());
  }

  /** What a variable's binding in {@code scope} stands for. */
  Symbol variable(Binding binding, FunctionScope scope) {
    return switch (binding) {
      case Binding.Global(String name) -> new Symbol.Global(name);
      case Binding.Local(String name) -> local(name, scope);
    };
  }

  private Symbol local(String name, FunctionScope scope) {
    Set<String> known = locals.computeIfAbsent(scope, key -> new HashSet<>(key.locals()));
    if (!known.contains(name) || scope.definition().isEmpty()) {
      return new Symbol.Unknown(name);
    }
    Definition owner = scope.definition().get();
    int at = owner.nameRange().start();
    for (ParameterDeclaration parameter : owner.parameters()) {
      if (parameter.name().equals(name)) {
        return new Symbol.Parameter(name, at);
      }
    }
    return new Symbol.Local(name, at);
  }

  /** The name at the start of {@code name = value}. */
  private static SourceRange head(SourceRange range, String name) {
    return new SourceRange(range.start(), range.start() + name.length());
  }

  private void note(Symbol symbol, SourceRange range, Role role) {
    found.add(new Occurrence(symbol, range, role));
  }
}
