package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToIntFunction;
import org.pendant.language.signature.Parameter;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.MethodCall;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;

/**
 * Call compiler: compiles calls of functions, built-ins and methods, with their arguments in
 * consecutive slots.
 */
final class CallCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final Builtins<?> builtins;
  private final PartCompiler parts;

  CallCompiler(FunctionContext context, ExpressionCompiler expressions, Builtins<?> builtins) {
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
      callDefined(call, definition.get(), target);
    } else {
      callBuiltin(call, builtins.find(call.function()).orElseThrow(), target);
    }
  }

  private void callDefined(Call call, Statement.Definition definition, int target) {
    List<ParameterDeclaration> parameters = definition.parameters();
    List<String> names = parameters.stream().map(ParameterDeclaration::name).toList();
    int first = context.temporaries(names.size());
    boolean[] given = new boolean[names.size()];
    arguments(call.arguments(), names::indexOf, first, true, given);
    List<String> missing = new ArrayList<>();
    for (int i = 0; i < given.length; i++) {
      if (given[i]) {
        continue;
      }
      Optional<Expression> value = parameters.get(i).defaultValue();
      if (value.isEmpty()) {
        missing.add(names.get(i));
      } else if (ConstantValues.of(value.get()).isPresent()) {
        expressions.argument(value.get(), first + i, true);
      } else {
        // the function finds it out
        code.emit(Op.UNSET, Instruction.local(first + i), 0, 0);
      }
    }
    code.at(call.range());
    if (missing.isEmpty()) {
      int number = context.linkage().function(definition);
      code.emit(Op.CALL, target, number, Instruction.local(first));
    } else {
      fail(call, missing, definition.head());
    }
  }

  private void callBuiltin(Call call, Builtin<?> builtin, int target) {
    List<Parameter> parameters = builtin.signature().parameters();
    int first = context.temporaries(parameters.size());
    boolean[] given = new boolean[parameters.size()];
    arguments(call.arguments(), name -> position(parameters, name), first, false, given);
    List<String> missing = new ArrayList<>();
    for (int i = 0; i < given.length; i++) {
      if (given[i]) {
        continue;
      }
      Optional<Value> value = builtin.defaults().get(i);
      int slot = Instruction.local(first + i);
      if (value.isPresent()) {
        code.emit(Op.MOVE, slot, context.constant(value.get()), 0);
      } else if (parameters.get(i).required()) {
        missing.add(parameters.get(i).name());
      } else {
        code.emit(Op.UNSET, slot, 0, 0);
      }
    }
    code.at(call.range());
    if (missing.isEmpty()) {
      int number = context.linkage().builtin(builtin);
      code.emit(Op.CALL_BUILTIN, target, number, Instruction.local(first));
    } else {
      fail(call, missing, builtin.signature().head());
    }
  }

  /** In place of a call that lacks arguments: robots notice that when they come to it. */
  private void fail(Call call, List<String> missing, String head) {
    String message = text("calledWithout", call.function(), String.join(", ", missing), head);
    code.emit(Op.MISSING, 0, context.linkage().name(message), 0);
  }

  private static int position(List<Parameter> parameters, String name) {
    int position = 0;
    while (!parameters.get(position).named(name)) {
      position++;
    }
    return position;
  }

  /** Evaluates arguments in the order of the text, and notes which parameters were given. */
  private void arguments(
      List<Argument> arguments,
      ToIntFunction<String> position,
      int first,
      boolean copied,
      boolean[] given) {
    for (int i = 0; i < arguments.size(); i++) {
      Argument argument = arguments.get(i);
      int place = argument.name().isPresent() ? position.applyAsInt(argument.name().get()) : i;
      given[place] = true;
      expressions.argument(argument.value(), first + place, copied);
    }
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
