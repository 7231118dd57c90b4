package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;

/**
 * Expression check: checks expressions, innermost first; each answers what its value certainly is.
 */
final class ExpressionCheck {
  private final CheckRun run;
  private final FunctionState state;
  private final ArgumentCheck arguments;

  ExpressionCheck(CheckRun run, FunctionState state) {
    this.run = run;
    this.state = state;
    this.arguments = new ArgumentCheck(run, this, state);
  }

  StaticType check(Expression expression) {
    return switch (expression) {
      case Expression.IntLiteral _, Expression.FloatLiteral _ -> StaticType.NUMBER;
      case Expression.StringLiteral _ -> StaticType.STRING;
      case Expression.BoolLiteral _ -> StaticType.BOOL;
      case Expression.NoneLiteral _ -> StaticType.ANY;
      case Expression.Name name -> name(name);
      case Expression.PoseLiteral pose -> pose(pose);
      case Expression.ListLiteral list -> Inference.list(all(list.elements()));
      case Expression.Unary unary -> unary(unary);
      case Expression.Binary binary -> binary(binary);
      case Expression.Call call -> call(call);
      case Expression.MethodCall call -> method(call);
      case Expression.Member member -> member(member);
      case Expression.Index index -> index(index);
      case Expression.Run start -> start(start);
    };
  }

  /** A condition of {@code if} or {@code while}. */
  void condition(Expression condition) {
    StaticType kind = check(condition);
    if (!kind.condition()) {
      mismatch(condition.range(), text("conditionType", kind.text()));
    }
  }

  /** The operand of {@code join} or {@code kill}. */
  void handle(Expression handle) {
    StaticType kind = check(handle);
    if (kind.certain() && kind != StaticType.NUMBER) {
      mismatch(handle.range(), text("operandNoThread", kind.text()));
    }
  }

  /** Whether a pose element, an index or the like certainly cannot be this. */
  static boolean isNoNumber(StaticType kind) {
    return kind.certain() && kind != StaticType.NUMBER && kind != StaticType.BOOL;
  }

  private List<StaticType> all(List<Expression> expressions) {
    List<StaticType> kinds = new ArrayList<>(expressions.size());
    for (Expression expression : expressions) {
      kinds.add(check(expression));
    }
    return kinds;
  }

  private StaticType name(Expression.Name name) {
    FunctionScope scope = state.scope();
    Binding binding = scope.resolve(name.name(), name.range().start());
    boolean local = binding instanceof Binding.Local;
    if (local && !scope.binds(name.name())) {
      if (FunctionScope.truth(name.name()).isPresent()) {
        return StaticType.BOOL;
      }
      run.unknownVariable(name.name(), name.range(), scope);
      return StaticType.ANY;
    }
    StaticType kind = state.flow().kind(binding);
    if (kind.certain()) {
      return kind;
    }
    if (certainlyUnassigned(binding)) {
      run.unassigned(name.range(), text("readBeforeAssigned", name.name()));
      state.flow().assigned(binding);
    }
    return run.survey().kind(scope, binding);
  }

  private boolean certainlyUnassigned(Binding binding) {
    if (state.flow().mayBeAssigned(binding)) {
      return false;
    }
    return switch (binding) {
      case Binding.Local(String name) -> !state.scope().startsAssigned(name);
      case Binding.Global(String name) ->
          state.scope().mainLevel()
              && !run.interpreted()
              && !run.survey().assignedInFunctions(name);
    };
  }

  private StaticType pose(Expression.PoseLiteral pose) {
    for (Expression element : pose.elements()) {
      StaticType kind = check(element);
      if (isNoNumber(kind)) {
        mismatch(element.range(), text("poseElementType", kind.text()));
      }
    }
    return StaticType.POSE;
  }

  private StaticType unary(Expression.Unary unary) {
    StaticType operand = check(unary.operand());
    if (OperatorTypes.fails(unary.operator(), operand)) {
      mismatch(unary.range(), text("operatorOperand", unary.operator().text(), operand.text()));
    }
    return OperatorTypes.result(unary.operator(), operand);
  }

  private StaticType binary(Expression.Binary binary) {
    StaticType left = check(binary.left());
    StaticType right = check(binary.right());
    if (OperatorTypes.fails(binary.operator(), left, right)) {
      mismatch(
          binary.range(),
          text("operatorOperands", binary.operator().text(), left.text(), right.text()));
    }
    return OperatorTypes.result(binary.operator(), left, right);
  }

  private StaticType index(Expression.Index index) {
    StaticType receiver = check(index.receiver());
    List<StaticType> indices = all(index.indices());
    if (receiver == StaticType.NUMBER || receiver == StaticType.BOOL) {
      mismatch(index.receiver().range(), text("noElements", receiver.text()));
    }
    for (int i = 0; i < indices.size(); i++) {
      if (isNoNumber(indices.get(i))) {
        mismatch(index.indices().get(i).range(), text("indexType", indices.get(i).text()));
      }
    }
    boolean flat =
        receiver == StaticType.LIST || receiver == StaticType.POSE || receiver == StaticType.STRUCT;
    if (flat && indices.size() > 1) {
      mismatch(index.range(), text("oneIndex", receiver.text(), indices.size()));
    }
    return Inference.index(receiver, indices.size());
  }

  private StaticType member(Expression.Member member) {
    StaticType receiver = check(member.receiver());
    switch (receiver) {
      case BOOL, STRING, POSE, LIST, MATRIX ->
          run.findings()
              .error(
                  "unknown-member",
                  member.nameRange(),
                  text("noMembers", receiver.text(), member.member()));
      case ANY, NUMBER, STRUCT -> {}
    }
    return StaticType.ANY;
  }

  private StaticType call(Expression.Call call) {
    String name = call.function();
    Optional<Definition> defined = state.scope().function(name);
    if (defined.isPresent()) {
      callDefined(defined.get(), call);
      return StaticType.ANY;
    }
    if (name.equals(Inference.STRUCT)) {
      arguments.checkStruct(call.arguments(), call.nameRange());
      return StaticType.STRUCT;
    }
    Optional<CheckRun.Builtin> builtin = run.builtin(name);
    if (builtin.isEmpty()) {
      run.unknownFunction(name, call.nameRange(), state.scope());
      checkValues(call.arguments());
      state.waits();
      return StaticType.ANY;
    }
    Signature signature = builtin.get().signature();
    arguments.check(builtin.get().head(), call.arguments(), call.nameRange());
    run.calls(signature, call.nameRange(), state.scope());
    noteTime(signature, call.nameRange());
    return StaticType.of(signature.result());
  }

  private void callDefined(Definition definition, Expression.Call call) {
    if (definition.kind() == DefinitionKind.FUNCTION) {
      arguments.check(run.head(definition), call.arguments(), call.nameRange());
      state.calls(run.graph().node(definition));
      return;
    }
    checkValues(call.arguments());
    state.waits();
    String name = definition.name();
    String message =
        definition.kind() == DefinitionKind.THREAD
            ? text("threadIsCalled", name, name)
            : text("secondaryIsCalled", name);
    run.findings().error("not-a-function", call.nameRange(), message);
  }

  private StaticType method(Expression.MethodCall call) {
    StaticType receiver = check(call.receiver());
    return switch (receiver) {
      case LIST, MATRIX, STRUCT -> knownMethod(call, receiver);
      case ANY, BOOL, NUMBER, STRING, POSE -> {
        checkValues(call.arguments());
        // A remote procedure waits for its answer.
        state.waits();
        yield StaticType.ANY;
      }
    };
  }

  private StaticType knownMethod(Expression.MethodCall call, StaticType receiver) {
    Optional<Signature> signature = run.catalogue().method(receiver.receiver(), call.method());
    if (signature.isEmpty()) {
      checkValues(call.arguments());
      String message = text("noMethod", receiver.text(), call.method());
      run.findings()
          .error(
              "unknown-method",
              call.nameRange(),
              CheckRun.offering(message, run.nearest(call.method(), () -> methods(receiver))));
      return StaticType.ANY;
    }
    arguments.check(FunctionHead.of(signature.get()), call.arguments(), call.nameRange());
    noteTime(signature.get(), call.nameRange());
    return StaticType.of(signature.get().result());
  }

  private List<String> methods(StaticType receiver) {
    return run.catalogue().all().stream()
        .filter(method -> method.receiver().equals(Optional.of(receiver.receiver())))
        .map(Signature::name)
        .toList();
  }

  private StaticType start(Expression.Run start) {
    checkValues(start.arguments());
    String name = start.thread();
    state.node().refuseInSecondary(start.range(), "runInSecondary");
    Optional<Definition> defined = state.scope().function(name);
    if (defined.isEmpty() && run.builtin(name).isEmpty()) {
      run.unknownFunction(name, start.nameRange(), state.scope());
    } else if (defined.filter(d -> d.kind() == DefinitionKind.THREAD).isEmpty()) {
      run.findings().error("not-a-thread", start.nameRange(), text("functionIsRun", name));
    } else if (!start.arguments().isEmpty()) {
      run.findings()
          .error(
              "thread-arguments",
              start.arguments().getFirst().range(),
              text("threadArguments", name, name));
    }
    return StaticType.NUMBER;
  }

  private void checkValues(List<Argument> values) {
    for (Argument argument : values) {
      check(argument.value());
    }
  }

  private void noteTime(Signature signature, SourceRange range) {
    if (signature.physicalTime()) {
      state.waits();
      state.node().refuseInSecondary(range, "timeInSecondary", signature.name());
    } else if (!signature.allowedInSecondary()) {
      state.waits();
      state.node().refuseInSecondary(range, "waitInSecondary", signature.name());
    }
  }

  private void mismatch(SourceRange range, String message) {
    run.findings().error("type-mismatch", range, message);
  }
}
