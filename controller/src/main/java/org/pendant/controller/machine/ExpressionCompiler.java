package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.value.Value;
import org.pendant.language.check.Binding;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.MethodCall;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.Run;
import org.pendant.language.syntax.Expression.Unary;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;

/**
 * Compiles the expressions of one function. A value that already has a slot (a variable, a
 * constant) is used where it stands; everything else goes to temporaries, which are taken and given
 * back like a stack.
 */
final class ExpressionCompiler {
  private final CodeBuilder code = new CodeBuilder();
  private final Source source;
  private final FunctionScope scope;
  private final Builtins builtins;
  private final Linkage linkage;
  private final List<String> variables;
  private final Map<String, Integer> variableSlots = new HashMap<>();
  private int nextTemporary;
  private int slotCount;

  /**
   * @param variables parameters and local variables in the order of their slots
   */
  ExpressionCompiler(
      Source source,
      FunctionScope scope,
      Builtins builtins,
      Linkage linkage,
      List<String> variables) {
    this.source = source;
    this.scope = scope;
    this.builtins = builtins;
    this.linkage = linkage;
    this.variables = variables;
    for (int i = 0; i < variables.size(); i++) {
      variableSlots.putIfAbsent(variables.get(i), i);
    }
    nextTemporary = variables.size();
    slotCount = nextTemporary;
  }

  CodeBuilder code() {
    return code;
  }

  ScriptFunction function(String name, int parameterCount) {
    return new ScriptFunction(
        name,
        source,
        code.code(),
        code.starts(),
        code.ends(),
        parameterCount,
        variables,
        slotCount,
        scope);
  }

  // --- temporaries

  private int temporary() {
    return temporaries(1);
  }

  /** The index of the first of {@code count} consecutive temporaries. */
  private int temporaries(int count) {
    int first = nextTemporary;
    nextTemporary += count;
    slotCount = Math.max(slotCount, nextTemporary);
    if (slotCount > Instruction.MAX_OPERAND) {
      throw new ProgramTooLarge("one expression needs more than 131071 values at once");
    }
    return first;
  }

  // --- statements that are mostly an expression

  /** Evaluates for the effect alone. */
  void effect(Expression expression) {
    int mark = nextTemporary;
    operand(expression);
    nextTemporary = mark;
  }

  void handle(int operation, Expression expression) {
    int mark = nextTemporary;
    int operand = operand(expression);
    code.emit(operation, operand, 0, 0);
    nextTemporary = mark;
  }

  void giveBack(Expression value) {
    int mark = nextTemporary;
    int operand =
        value instanceof Name name && binding(name) instanceof Binding.Local
            ? operand(value)
            : owned(value);
    code.at(value.range());
    code.emit(Op.RETURN, operand, 0, 0);
    nextTemporary = mark;
  }

  void assignGlobal(String name, Expression value) {
    int mark = nextTemporary;
    int operand = operand(value);
    code.emit(
        fresh(value) ? Op.ASSIGN : Op.ASSIGN_COPY, linkage.statics().global(name), operand, 0);
    nextTemporary = mark;
  }

  void assign(Statement.Assign assign) {
    int mark = nextTemporary;
    switch (assign.target()) {
      case Name name -> assignVariable(assign, variable(scope.target(assign)));
      case Index index -> {
        int value = owned(assign.value());
        setIndex(assign, index, value);
      }
      case Member member -> {
        int value = owned(assign.value());
        setMember(assign, member, value);
      }
      default -> throw new IllegalStateException("cannot assign to " + source.text(assign.range()));
    }
    nextTemporary = mark;
  }

  private void assignVariable(Statement.Assign assign, int target) {
    Expression value = assign.value();
    switch (value) {
      case Binary binary when isArithmetic(binary.operator()) -> arithmetic(binary, target);
      case Index index when index.indices().size() == 1 -> {
        // an element that is not a number must be copied out of its container
        int element = operand(value);
        code.at(assign.range());
        code.emit(Op.ASSIGN_COPY, target, element, 0);
      }
      default -> {
        int operand = operand(value);
        code.at(assign.range());
        code.emit(fresh(value) ? Op.ASSIGN : Op.ASSIGN_COPY, target, operand, 0);
      }
    }
  }

  /** Stores into {@code target[...]}, and the changed container back into its own container. */
  private void setIndex(Statement.Assign assign, Index target, int value) {
    int container = place(assign, target.receiver());
    if (target.indices().size() == 1) {
      int index = operand(target.indices().get(0));
      code.at(assign.range());
      code.emit(Op.SET_INDEX, container, index, value);
    } else {
      int pair = pair(target);
      code.at(assign.range());
      code.emit(Op.SET_INDEX_2, container, Instruction.local(pair), value);
    }
    putBack(assign, target.receiver(), container);
  }

  private void setMember(Statement.Assign assign, Member target, int value) {
    int container = place(assign, target.receiver());
    code.at(assign.range());
    code.emit(Op.SET_MEMBER, container, linkage.name(target.member()), value);
    putBack(assign, target.receiver(), container);
  }

  /** The operand of the container that an assignment changes: a variable, or a part of one. */
  private int place(Statement.Assign assign, Expression container) {
    return container instanceof Name ? variable(scope.target(assign)) : part(container, true);
  }

  /** A pose is replaced, not changed, so what holds it takes the new one. */
  private void putBack(Statement.Assign assign, Expression container, int value) {
    switch (container) {
      case Index index -> setIndex(assign, index, value);
      case Member member -> setMember(assign, member, value);
      default -> {}
    }
  }

  // --- conditions

  /** Jumps when the truth of {@code expression} is {@code when}; {@code jumps} collects them. */
  void condition(Expression expression, boolean when, List<Integer> jumps) {
    switch (expression) {
      case Expression.BoolLiteral literal -> {
        if (literal.value() == when) {
          jumps.add(code.emitJump(Op.JUMP, 0));
        }
      }
      case Unary unary when unary.operator() == UnaryOperator.NOT ->
          condition(unary.operand(), !when, jumps);
      case Binary binary when binary.operator() == BinaryOperator.AND ->
          both(binary, when, false, jumps);
      case Binary binary when binary.operator() == BinaryOperator.OR ->
          both(binary, when, true, jumps);
      case Binary binary when isComparison(binary.operator()) -> compare(binary, when, jumps);
      default -> {
        int mark = nextTemporary;
        int operand = operand(expression);
        code.at(expression.range());
        jumps.add(code.emitJump(when ? Op.JUMP_IF_TRUE : Op.JUMP_IF_FALSE, operand));
        nextTemporary = mark;
      }
    }
  }

  /** {@code and} and {@code or}: the left side decides alone when it is {@code deciding}. */
  private void both(Binary binary, boolean when, boolean deciding, List<Integer> jumps) {
    if (when == deciding) {
      condition(binary.left(), when, jumps);
      condition(binary.right(), when, jumps);
    } else {
      List<Integer> decided = new ArrayList<>();
      condition(binary.left(), deciding, decided);
      condition(binary.right(), when, jumps);
      decided.forEach(jump -> code.land(jump, code.size()));
    }
  }

  private void compare(Binary binary, boolean when, List<Integer> jumps) {
    int mark = nextTemporary;
    int left = stable(binary.left(), binary.right());
    int right = operand(binary.right());
    code.at(binary.range());
    jumps.add(
        switch (binary.operator()) {
          case LESS -> code.emit(when ? Op.JUMP_IF_LESS : Op.JUMP_IF_NOT_LESS, left, right, 0);
          case LESS_OR_EQUAL ->
              code.emit(
                  when ? Op.JUMP_IF_LESS_OR_EQUAL : Op.JUMP_IF_NOT_LESS_OR_EQUAL, left, right, 0);
          case GREATER -> code.emit(when ? Op.JUMP_IF_LESS : Op.JUMP_IF_NOT_LESS, right, left, 0);
          case GREATER_OR_EQUAL ->
              code.emit(
                  when ? Op.JUMP_IF_LESS_OR_EQUAL : Op.JUMP_IF_NOT_LESS_OR_EQUAL, right, left, 0);
          case EQUAL -> code.emit(when ? Op.JUMP_IF_EQUAL : Op.JUMP_IF_NOT_EQUAL, left, right, 0);
          default -> code.emit(when ? Op.JUMP_IF_NOT_EQUAL : Op.JUMP_IF_EQUAL, left, right, 0);
        });
    nextTemporary = mark;
  }

  /** The end of a loop: back to {@code body} when the condition still holds. */
  void repeat(Expression condition, int top, int body) {
    int mark = nextTemporary;
    if (condition instanceof Binary binary && isOrder(binary.operator())) {
      int left = stable(binary.left(), binary.right());
      int right = operand(binary.right());
      int jump =
          switch (binary.operator()) {
            case LESS -> code.emit(Op.LOOP_IF_LESS, left, right, 0);
            case LESS_OR_EQUAL -> code.emit(Op.LOOP_IF_LESS_OR_EQUAL, left, right, 0);
            case GREATER -> code.emit(Op.LOOP_IF_LESS, right, left, 0);
            default -> code.emit(Op.LOOP_IF_LESS_OR_EQUAL, right, left, 0);
          };
      code.land(jump, body);
    } else {
      code.land(code.emitJump(Op.LOOP, 0), top);
    }
    nextTemporary = mark;
  }

  // --- expressions

  /** Compiles {@code expression} and answers the operand of the slot that holds its value. */
  int operand(Expression expression) {
    Optional<Value> constant = ConstantValues.of(expression);
    if (constant.isPresent()) {
      return linkage.statics().constant(constant.get());
    }
    if (expression instanceof Name name) {
      return variable(binding(name));
    }
    int target = temporary();
    int mark = nextTemporary;
    into(expression, target);
    nextTemporary = mark;
    return Instruction.local(target);
  }

  /** As {@link #operand}, in a slot that nobody else holds: a container is copied if it must. */
  private int owned(Expression expression) {
    int operand = operand(expression);
    if (fresh(expression)) {
      return operand;
    }
    int copy = Instruction.local(temporary());
    code.at(expression.range());
    code.emit(Op.COPY, copy, operand, 0);
    return copy;
  }

  /** Whether the value of {@code expression} is new, so that it may be stored without a copy. */
  private static boolean fresh(Expression expression) {
    return switch (expression) {
      case Name name -> false;
      case Index index -> false;
      case Member member -> false;
      case Expression.ListLiteral list -> ConstantValues.of(list).isEmpty();
      default -> true;
    };
  }

  /**
   * The operand of a left side that is read only after the right side was evaluated: a variable
   * that the right side could change meanwhile is moved to a temporary first.
   */
  private int stable(Expression left, Expression right) {
    int operand = operand(left);
    if (left instanceof Name && ConstantValues.callsSomething(right)) {
      int copy = Instruction.local(temporary());
      code.at(left.range());
      code.emit(Op.MOVE, copy, operand, 0);
      return copy;
    }
    return operand;
  }

  /** Compiles {@code expression} so that its value stands in temporary {@code target}. */
  private void into(Expression expression, int target) {
    int local = Instruction.local(target);
    switch (expression) {
      case Binary binary when isArithmetic(binary.operator()) -> arithmetic(binary, local);
      case Binary binary when isComparison(binary.operator()) -> comparison(binary, local);
      case Binary binary when binary.operator() == BinaryOperator.XOR -> {
        int left = stable(binary.left(), binary.right());
        int right = operand(binary.right());
        code.at(binary.range());
        code.emit(Op.XOR, local, left, right);
      }
      case Binary binary -> truth(binary, local);
      case Unary unary -> unary(unary, local);
      case Call call when call.function().equals("struct") -> struct(call, local);
      case Call call -> call(call, local);
      case MethodCall call -> methodCall(call, local);
      case Index index -> getPart(index, local);
      case Member member -> getPart(member, local);
      case Run run -> {
        int thread = linkage.function(scope.function(run.thread()).orElseThrow());
        code.at(run.range());
        code.emit(Op.RUN, local, thread, 0);
      }
      case Expression.ListLiteral list -> {
        int first = elements(list.elements());
        code.at(list.range());
        code.emit(Op.LIST, local, list.elements().size(), Instruction.local(first));
      }
      case Expression.PoseLiteral pose -> {
        int first = elements(pose.elements());
        code.at(pose.range());
        code.emit(Op.POSE, local, 0, Instruction.local(first));
      }
      default -> {
        int operand = operand(expression);
        code.at(expression.range());
        code.emit(Op.MOVE, local, operand, 0);
      }
    }
  }

  private void arithmetic(Binary binary, int target) {
    int left = stable(binary.left(), binary.right());
    int right = operand(binary.right());
    int operation =
        switch (binary.operator()) {
          case ADD -> Op.ADD;
          case SUBTRACT -> Op.SUBTRACT;
          case MULTIPLY -> Op.MULTIPLY;
          case DIVIDE -> Op.DIVIDE;
          default -> Op.MODULO;
        };
    code.at(binary.range());
    code.emit(operation, target, left, right);
  }

  private void comparison(Binary binary, int target) {
    int left = stable(binary.left(), binary.right());
    int right = operand(binary.right());
    code.at(binary.range());
    switch (binary.operator()) {
      case EQUAL -> code.emit(Op.EQUAL, target, left, right);
      case NOT_EQUAL -> code.emit(Op.NOT_EQUAL, target, left, right);
      case LESS -> code.emit(Op.LESS, target, left, right);
      case LESS_OR_EQUAL -> code.emit(Op.LESS_OR_EQUAL, target, left, right);
      case GREATER -> code.emit(Op.LESS, target, right, left);
      default -> code.emit(Op.LESS_OR_EQUAL, target, right, left);
    }
  }

  /** The value of {@code and} or {@code or}, by jumps, so that the right side may be skipped. */
  private void truth(Binary binary, int target) {
    List<Integer> whenFalse = new ArrayList<>();
    condition(binary, false, whenFalse);
    code.at(binary.range());
    code.emit(Op.MOVE, target, linkage.statics().constant(Value.of(true)), 0);
    int end = code.emitJump(Op.JUMP, 0);
    whenFalse.forEach(jump -> code.land(jump, code.size()));
    code.emit(Op.MOVE, target, linkage.statics().constant(Value.of(false)), 0);
    code.land(end, code.size());
  }

  private void unary(Unary unary, int target) {
    int operand = operand(unary.operand());
    code.at(unary.range());
    switch (unary.operator()) {
      case NEGATE -> code.emit(Op.NEGATE, target, operand, 0);
      case NOT -> code.emit(Op.NOT, target, operand, 0);
      // plus refuses what cannot be negated: minus twice
      case PLUS -> {
        code.emit(Op.NEGATE, target, operand, 0);
        code.emit(Op.NEGATE, target, target, 0);
      }
    }
  }

  /** The operand of a part of a variable, not copied; {@code receiver} of an index or member. */
  private int part(Expression expression, boolean changed) {
    if (expression instanceof Name name) {
      return variable(binding(name));
    }
    int operand = operand(expression);
    if (changed && ConstantValues.of(expression).isPresent()) {
      return owned(expression);
    }
    return operand;
  }

  private void getPart(Expression expression, int target) {
    switch (expression) {
      case Index index when index.indices().size() == 1 -> {
        int receiver = part(index.receiver(), false);
        int place = operand(index.indices().get(0));
        code.at(index.range());
        code.emit(Op.GET_INDEX, target, receiver, place);
      }
      case Index index -> {
        int receiver = part(index.receiver(), false);
        int pair = pair(index);
        code.at(index.range());
        code.emit(Op.GET_INDEX_2, target, receiver, Instruction.local(pair));
      }
      case Member member -> {
        int receiver = part(member.receiver(), false);
        code.at(member.range());
        code.emit(Op.GET_MEMBER, target, receiver, linkage.name(member.member()));
      }
      default -> throw new IllegalStateException("not a part: " + expression);
    }
  }

  private int pair(Index index) {
    int pair = temporaries(2);
    into(index.indices().get(0), pair);
    into(index.indices().get(1), pair + 1);
    return pair;
  }

  /** Evaluates elements that a new container will own into consecutive temporaries. */
  private int elements(List<Expression> elements) {
    int first = temporaries(elements.size());
    for (int i = 0; i < elements.size(); i++) {
      argument(elements.get(i), first + i, true);
    }
    return first;
  }

  private void argument(Expression expression, int target, boolean copied) {
    int mark = nextTemporary;
    if (copied && !fresh(expression)) {
      int operand = operand(expression);
      code.at(expression.range());
      code.emit(Op.COPY, Instruction.local(target), operand, 0);
    } else if (expression instanceof Name || ConstantValues.of(expression).isPresent()) {
      int operand = operand(expression);
      code.at(expression.range());
      code.emit(Op.MOVE, Instruction.local(target), operand, 0);
    } else {
      into(expression, target);
    }
    nextTemporary = mark;
  }

  private void struct(Call call, int target) {
    List<String> names = call.arguments().stream().map(a -> a.name().orElseThrow()).toList();
    int first = elements(call.arguments().stream().map(Argument::value).toList());
    code.at(call.range());
    code.emit(Op.STRUCT, target, linkage.nameList(names), Instruction.local(first));
  }

  private void call(Call call, int target) {
    Optional<Statement.Definition> definition = scope.function(call.function());
    if (definition.isPresent()) {
      List<ParameterDeclaration> parameters = definition.get().parameters();
      int first = temporaries(parameters.size());
      boolean[] given =
          arguments(call.arguments(), parameters.stream().map(p -> p.name()).toList(), first, true);
      for (int i = 0; i < given.length; i++) {
        if (!given[i]) {
          argument(parameters.get(i).defaultValue().orElseThrow(), first + i, true);
        }
      }
      code.at(call.range());
      code.emit(Op.CALL, target, linkage.function(definition.get()), Instruction.local(first));
    } else {
      Builtin builtin = builtins.find(call.function()).orElseThrow();
      int first = temporaries(builtin.defaults().size());
      builtinArguments(builtin, call.arguments(), first);
      code.at(call.range());
      code.emit(Op.CALL_BUILTIN, target, linkage.builtin(builtin), Instruction.local(first));
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
          code.emit(Op.MOVE, slot, linkage.statics().constant(value.get()), 0);
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
      argument(argument.value(), first + place, copied);
    }
    return given;
  }

  /**
   * A method call. The receiver's own object is argument 0, so that methods change the variable.
   * Which method it is depends on the receiver's kind and is found when it runs; positional
   * arguments follow in order.
   */
  private void methodCall(MethodCall call, int target) {
    int count = call.arguments().size() + 1;
    int first = temporaries(count);
    int mark = nextTemporary;
    int receiver = part(call.receiver(), true);
    code.at(call.receiver().range());
    code.emit(Op.MOVE, Instruction.local(first), receiver, 0);
    nextTemporary = mark;
    for (int i = 1; i < count; i++) {
      argument(call.arguments().get(i - 1).value(), first + i, false);
    }
    code.at(call.range());
    code.emit(
        Op.CALL_METHOD,
        target,
        linkage.name(Methods.key(call.method(), count - 1)),
        Instruction.local(first));
  }

  // --- names

  private Binding binding(Name name) {
    return scope.resolve(name.name(), name.range().start());
  }

  private int variable(Binding binding) {
    return switch (binding) {
      case Binding.Global global -> linkage.statics().global(global.name());
      case Binding.Local local -> Instruction.local(variableSlots.get(local.name()));
    };
  }

  private static boolean isArithmetic(BinaryOperator operator) {
    return switch (operator) {
      case ADD, SUBTRACT, MULTIPLY, DIVIDE, MODULO -> true;
      default -> false;
    };
  }

  private static boolean isOrder(BinaryOperator operator) {
    return switch (operator) {
      case LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL -> true;
      default -> false;
    };
  }

  private static boolean isComparison(BinaryOperator operator) {
    return isOrder(operator)
        || operator == BinaryOperator.EQUAL
        || operator == BinaryOperator.NOT_EQUAL;
  }
}
