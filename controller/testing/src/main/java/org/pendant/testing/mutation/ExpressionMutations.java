package org.pendant.testing.mutation;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Parameter;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.BoolLiteral;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.FloatLiteral;
import org.pendant.language.syntax.Expression.IntLiteral;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Expression mutations: those within the expressions of one statement. */
final class ExpressionMutations {
  private static final Set<String> OF_MOVES = Set.of("a", "v", "t", "r");
  private static final BigDecimal LARGER = new BigDecimal("1.1");
  private static final int MAX_DIGITS = 20;
  private static final BigDecimal TWICE = BigDecimal.TWO;

  private final Source source;
  private final Builtins<ControlBox> builtins;
  private final int reach;
  private final List<Mutation> found;

  /**
   * Those of one statement.
   *
   * @param reach its line
   * @param found where they are added
   */
  ExpressionMutations(
      Source source, Builtins<ControlBox> builtins, int reach, List<Mutation> found) {
    this.source = source;
    this.builtins = builtins;
    this.reach = reach;
    this.found = found;
  }

  /** Adds those within an expression. */
  void look(Expression expression) {
    switch (expression) {
      case Binary binary -> {
        operator(binary);
        look(binary.left());
        look(binary.right());
      }
      case Call call -> call(call);
      case Expression.MethodCall call -> {
        look(call.receiver());
        call.arguments().forEach(each -> look(each.value()));
      }
      case Expression.Run run -> run.arguments().forEach(each -> look(each.value()));
      case Expression.PoseLiteral pose -> pose.elements().forEach(this::look);
      case Expression.ListLiteral list -> list.elements().forEach(this::look);
      case Expression.Unary unary -> look(unary.operand());
      case Expression.Member member -> look(member.receiver());
      case Expression.Index index -> {
        look(index.receiver());
        index.indices().forEach(this::look);
      }
      case IntLiteral number -> number(MutationKind.CONSTANT, number.range(), number);
      case FloatLiteral number -> number(MutationKind.CONSTANT, number.range(), number);
      case BoolLiteral truth -> inverted(MutationKind.CONSTANT, truth);
      case Expression.StringLiteral _, Expression.NoneLiteral _, Expression.Name _ -> {}
    }
  }

  private void add(MutationKind kind, SourceRange range, String replacement) {
    found.add(new Mutation(kind, range, replacement, reach));
  }

  private void inverted(MutationKind kind, BoolLiteral truth) {
    add(kind, truth.range(), truth.value() ? "False" : "True");
  }

  private void operator(Binary binary) {
    MutationKind kind =
        switch (binary.operator()) {
          case OR, XOR, AND -> MutationKind.LOGIC;
          case EQUAL, NOT_EQUAL, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL ->
              MutationKind.COMPARISON;
          case ADD, SUBTRACT, MULTIPLY, DIVIDE, MODULO -> MutationKind.ARITHMETIC;
        };
    String word = binary.operator().text();
    int from = binary.left().range().end();
    int at = source.text().indexOf(word, from);
    // && and || are written in other words
    if (at >= 0 && at < binary.right().range().start()) {
      add(kind, new SourceRange(at, at + word.length()), other(binary.operator()).text());
    }
  }

  private static BinaryOperator other(BinaryOperator operator) {
    return switch (operator) {
      case OR, XOR -> BinaryOperator.AND;
      case AND -> BinaryOperator.OR;
      case EQUAL -> BinaryOperator.NOT_EQUAL;
      case NOT_EQUAL -> BinaryOperator.EQUAL;
      case LESS -> BinaryOperator.LESS_OR_EQUAL;
      case GREATER -> BinaryOperator.GREATER_OR_EQUAL;
      case LESS_OR_EQUAL -> BinaryOperator.LESS;
      case GREATER_OR_EQUAL -> BinaryOperator.GREATER;
      case ADD -> BinaryOperator.SUBTRACT;
      case SUBTRACT -> BinaryOperator.ADD;
      case MULTIPLY -> BinaryOperator.DIVIDE;
      case DIVIDE, MODULO -> BinaryOperator.MULTIPLY;
    };
  }

  private void call(Call call) {
    Optional<Builtin<ControlBox>> builtin = builtins.find(call.function());
    for (int i = 0; i < call.arguments().size(); i++) {
      Argument argument = call.arguments().get(i);
      Optional<String> parameter =
          argument.name().or(positional(builtin, i)).map(name -> parameter(builtin, name));
      if (builtin.isEmpty()
          || parameter.isEmpty()
          || !of(builtin.get(), parameter.get(), argument)) {
        look(argument.value());
      }
    }
  }

  private static Supplier<Optional<String>> positional(
      Optional<Builtin<ControlBox>> builtin, int number) {
    return () ->
        builtin
            .map(each -> each.signature().parameters())
            .filter(all -> number < all.size())
            .map(all -> all.get(number).name());
  }

  /** The name that a parameter has in our own declaration. */
  private static String parameter(Optional<Builtin<ControlBox>> builtin, String name) {
    return builtin.stream()
        .flatMap(each -> each.signature().parameters().stream())
        .filter(each -> each.named(name))
        .map(Parameter::name)
        .findFirst()
        .orElse(name);
  }

  /** Adds what is made of an argument that means more than its value; whether it does. */
  private boolean of(Builtin<ControlBox> builtin, String parameter, Argument argument) {
    if (isSignal(builtin.name())) {
      switch (argument.value()) {
        // the other one of a pair, so that there is one
        case IntLiteral number when parameter.equals("n") ->
            add(MutationKind.IO_SWAPPED, number.range(), Integer.toString(number.value() ^ 1));
        case BoolLiteral level -> inverted(MutationKind.IO_SWAPPED, level);
        default -> {
          return false;
        }
      }
      return true;
    }
    boolean moves = builtin.effect() == Effect.MOVES || builtin.signature().physicalTime();
    if (moves && OF_MOVES.contains(parameter)) {
      twice(MutationKind.SPEED, argument.value());
      return true;
    }
    if (builtin.name().contains("payload") && parameter.equals("m")) {
      twice(MutationKind.PAYLOAD, argument.value());
      return true;
    }
    return false;
  }

  private static boolean isSignal(String function) {
    return function.matches("[gs]et_(\\w+_)?(digital|analog)_(in|out)|[gs]et_flag");
  }

  private void twice(MutationKind kind, Expression value) {
    switch (value) {
      case IntLiteral number -> number(kind, value.range(), number);
      case FloatLiteral number -> number(kind, value.range(), number);
      case Expression.Name _ -> add(kind, value.range(), "2 * " + source.text(value.range()));
      default -> add(kind, value.range(), "2 * (" + source.text(value.range()) + ")");
    }
  }

  /** A number that is larger: whole ones by one, others by a tenth, speeds by themselves. */
  private void number(MutationKind kind, SourceRange range, Expression number) {
    boolean constant = kind == MutationKind.CONSTANT;
    switch (number) {
      // twice nothing is nothing
      case IntLiteral(int value, var _) when constant || value != 0 ->
          add(kind, range, Long.toString(constant ? value + 1L : value * 2L));
      case FloatLiteral(double value, var _) when value != 0 ->
          add(kind, range, larger(source.text(range), value, constant ? LARGER : TWICE));
      case FloatLiteral _ when constant -> add(kind, range, "1.0");
      default -> {}
    }
  }

  /** A number as people would write it, where it has not too many digits. */
  private static String larger(String text, double value, BigDecimal factor) {
    if (Math.abs(value) > 1e9 || Math.abs(value) < 1e-9 || text.length() > MAX_DIGITS) {
      double most = Math.min(value * factor.doubleValue(), Double.MAX_VALUE);
      return Double.toString(most);
    }
    String plain = new BigDecimal(text).multiply(factor).stripTrailingZeros().toPlainString();
    return plain.contains(".") ? plain : plain + ".0";
  }
}
