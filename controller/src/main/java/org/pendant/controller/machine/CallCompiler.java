package org.pendant.controller.machine;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.value.Value;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.MethodCall;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;

/**
 * Compiles calls of functions, built-ins and methods, with their arguments in consecutive slots.
 */
final class CallCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final Builtins builtins;
  private final PartCompiler parts;

  CallCompiler(FunctionContext context, ExpressionCompiler expressions, Builtins builtins) {
    this.context = context;
    this.code = context.code();
    this.expressions = expressions;
    this.builtins = builtins;
    parts = new PartCompiler(context, expressions);
  }

  void struct(Call call, int target) {
    List<String> names = call.arguments().stream().map(a -> a.name().orElseThrow()).toList();
    int first = expressions.elements(call.arguments().stream().map(Argument::value).toList());
    code.at(call.range());
    code.emit(Op.STRUCT, target, context.linkage().nameList(names), Instruction.local(first));
  }

  void call(Call call, int target) {
    Optional<Statement.Definition> definition = context.scope().function(call.function());
    if (definition.isPresent()) {
      List<ParameterDeclaration> parameters = definition.get().parameters();
      int first = context.temporaries(parameters.size());
      boolean[] given =
          arguments(call.arguments(), parameters.stream().map(p -> p.name()).toList(), first, true);
      for (int i = 0; i < given.length; i++) {
        if (!given[i]) {
          expressions.argument(parameters.get(i).defaultValue().orElseThrow(), first + i, true);
        }
      }
      code.at(call.range());
      code.emit(
          Op.CALL, target, context.linkage().function(definition.get()), Instruction.local(first));
    } else {
      Builtin builtin = builtins.find(call.function()).orElseThrow();
      int first = context.temporaries(builtin.defaults().size());
      builtinArguments(builtin, call.arguments(), first);
      code.at(call.range());
      code.emit(
          Op.CALL_BUILTIN, target, context.linkage().builtin(builtin), Instruction.local(first));
    }
  }

  private void builtinArguments(Builtin builtin, List<Argument> arguments, int first) {
    boolean[] given =
        arguments(
            arguments,
            builtin.signature().parameters().stream().map(p -> p.name()).toList(),
            first,
            false);
    for (int i = 0; i < given.length; i++) {
      if (!given[i]) {
        int slot = Instruction.local(first + i);
        Optional<Value> value = builtin.defaults().get(i);
        if (value.isPresent()) {
          code.emit(Op.MOVE, slot, context.constant(value.get()), 0);
        } else {
          code.emit(Op.UNSET, slot, 0, 0);
        }
      }
    }
  }

  /** Evaluates arguments in the order of the text; answers which parameters were given. */
  private boolean[] arguments(
      List<Argument> arguments, List<String> parameters, int first, boolean copied) {
    boolean[] given = new boolean[parameters.size()];
    for (int i = 0; i < arguments.size(); i++) {
      Argument argument = arguments.get(i);
      int place = argument.name().map(parameters::indexOf).orElse(i);
      given[place] = true;
      expressions.argument(argument.value(), first + place, copied);
    }
    return given;
  }

  /**
   * A method call. The receiver's own object is argument 0, so that methods change the variable.
   * Which method it is depends on the receiver's kind and is found when it runs; positional
   * arguments follow in order.
   */
  void methodCall(MethodCall call, int target) {
    int count = call.arguments().size() + 1;
    int first = context.temporaries(count);
    boolean changesPart = builtins.changesReceiver(call.method()) && isPart(call.receiver());
    if (changesPart) {
      List<Expression> arguments = call.arguments().stream().map(Argument::value).toList();
      int variable = context.variable(context.binding(FunctionContext.root(call.receiver())));
      PartCompiler.Part part = parts.part(call.receiver(), variable, arguments);
      arguments(call, first);
      receiver(call, first, parts.open(part).operand());
    } else {
      int mark = context.mark();
      receiver(call, first, expressions.part(call.receiver(), true));
      context.release(mark);
      arguments(call, first);
    }
    code.at(call.range());
    code.emit(
        changesPart ? Op.CALL_PART_METHOD : Op.CALL_METHOD,
        target,
        context.linkage().name(Methods.key(call.method(), count - 1)),
        Instruction.local(first));
  }

  /** Whether {@code receiver} is a part of a variable. */
  private static boolean isPart(Expression receiver) {
    return switch (receiver) {
      case Index index -> index.receiver() instanceof Name || isPart(index.receiver());
      case Member member -> member.receiver() instanceof Name || isPart(member.receiver());
      default -> false;
    };
  }

  private void receiver(MethodCall call, int first, int operand) {
    code.at(call.receiver().range());
    code.emit(Op.MOVE, Instruction.local(first), operand, 0);
  }

  private void arguments(MethodCall call, int first) {
    for (int i = 0; i < call.arguments().size(); i++) {
      expressions.argument(call.arguments().get(i).value(), first + 1 + i, false);
    }
  }
}
