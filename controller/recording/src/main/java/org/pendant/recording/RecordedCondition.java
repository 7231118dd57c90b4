package org.pendant.recording;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Operators;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Recorded condition: the condition of a breakpoint, computed from the variables of a recording.
 * Literals, variables, elements, members and operators are known there; what functions would have
 * answered is not.
 */
public final class RecordedCondition {
  private final Optional<Expression> expression;

  /** A part of it is not in the recording. */
  private static final class Unknown extends Exception {
    private static final long serialVersionUID = 1;

    Unknown() {
      super("not in the recording", null, false, false);
    }
  }

  /**
   * Reads a condition.
   *
   * @param text one character a byte, as in a program; blank for one that is always true
   */
  public RecordedCondition(String text) {
    expression = text.isBlank() ? Optional.of(always()) : read(text);
  }

  private static Expression always() {
    return read("True").orElseThrow();
  }

  private static Optional<Expression> read(String text) {
    Source source =
        Source.of("condition", ("it = (" + text + ")\n").getBytes(StandardCharsets.ISO_8859_1));
    return Optional.of(ScriptParser.parseLine(source))
        .filter(result -> result.ok() && result.script().statements().size() == 1)
        .map(result -> result.script().statements().getFirst())
        .flatMap(
            only ->
                only instanceof Statement.Assign it ? Optional.of(it.value()) : Optional.empty());
  }

  /** Whether it held; empty if the recording cannot tell. */
  public Optional<Boolean> holds(VariableSamples variables) {
    try {
      Optional<Value> value = value(variables);
      return value.isPresent() ? Optional.of(Operators.truth(value.get())) : Optional.empty();
    } catch (ScriptError e) {
      return Optional.empty();
    }
  }

  /** What it was as an expression; empty if the recording cannot tell. */
  public Optional<Value> value(VariableSamples variables) {
    if (expression.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(value(expression.get(), variables));
    } catch (Unknown | ScriptError e) {
      return Optional.empty();
    }
  }

  private static Value value(Expression of, VariableSamples variables) throws Unknown, ScriptError {
    return switch (of) {
      case Expression.IntLiteral literal -> new IntValue(literal.value());
      case Expression.FloatLiteral literal -> new FloatValue(literal.value());
      case Expression.BoolLiteral literal -> new BoolValue(literal.value());
      case Expression.StringLiteral literal -> new StringValue(literal.value());
      case Expression.Name name ->
          variables
              .find(new VariablePath(name.name(), List.of()))
              // a long one is not kept as a whole
              .filter(sample -> sample.kept() == sample.length())
              .flatMap(VariableSample::value)
              .orElseThrow(Unknown::new);
      case Expression.Member member ->
          Operators.member(value(member.receiver(), variables), member.member());
      case Expression.Index index -> index(index, variables);
      case Expression.ListLiteral list -> {
        List<Value> elements = new ArrayList<>();
        for (Expression each : list.elements()) {
          elements.add(value(each, variables));
        }
        yield Operators.listLiteral(elements);
      }
      case Expression.Unary unary -> {
        Value operand = value(unary.operand(), variables);
        yield switch (unary.operator()) {
          case NEGATE -> Operators.negate(operand);
          case PLUS -> operand;
          case NOT -> Operators.not(operand);
        };
      }
      case Expression.Binary binary -> binary(binary, variables);
      case Expression.NoneLiteral none -> throw new Unknown();
      case Expression.PoseLiteral pose -> throw new Unknown();
      case Expression.Call call -> throw new Unknown();
      case Expression.MethodCall call -> throw new Unknown();
      case Expression.Run run -> throw new Unknown();
    };
  }

  private static Value index(Expression.Index index, VariableSamples variables)
      throws Unknown, ScriptError {
    Value receiver = value(index.receiver(), variables);
    Value first = value(index.indices().getFirst(), variables);
    return index.indices().size() == 1
        ? Operators.index(receiver, first)
        : Operators.index(receiver, first, value(index.indices().getLast(), variables));
  }

  private static Value binary(Expression.Binary binary, VariableSamples variables)
      throws Unknown, ScriptError {
    Value left = value(binary.left(), variables);
    boolean decided =
        switch (binary.operator()) {
          case AND -> !Operators.truth(left);
          case OR -> Operators.truth(left);
          default -> false;
        };
    return decided
        ? left
        : Operators.binary(binary.operator(), left, value(binary.right(), variables));
  }
}
