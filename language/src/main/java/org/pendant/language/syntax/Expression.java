package org.pendant.language.syntax;

import java.util.List;
import org.pendant.language.source.SourceRange;

/** Expression: a piece of syntax that has a value. */
public sealed interface Expression extends Node {

  /** Operators before an operand. */
  enum UnaryOperator {
    NEGATE("-"),
    PLUS("+"),
    NOT("not");

    private final String text;

    UnaryOperator(String text) {
      this.text = text;
    }

    public String text() {
      return text;
    }
  }

  /** Operators between two operands, loosest first. */
  enum BinaryOperator {
    OR("or"),
    XOR("xor"),
    AND("and"),
    EQUAL("=="),
    NOT_EQUAL("!="),
    LESS("<"),
    GREATER(">"),
    LESS_OR_EQUAL("<="),
    GREATER_OR_EQUAL(">="),
    ADD("+"),
    SUBTRACT("-"),
    MULTIPLY("*"),
    DIVIDE("/"),
    MODULO("%");

    private final String text;

    BinaryOperator(String text) {
      this.text = text;
    }

    public String text() {
      return text;
    }
  }

  record IntLiteral(int value, SourceRange range) implements Expression {}

  record FloatLiteral(double value, SourceRange range) implements Expression {}

  /** A string; {@code value} holds one {@code char} a byte, exactly as between the quotes. */
  record StringLiteral(String value, SourceRange range) implements Expression {}

  record BoolLiteral(boolean value, SourceRange range) implements Expression {}

  record NoneLiteral(SourceRange range) implements Expression {}

  /** {@code p[x, y, z, rx, ry, rz]}; the parser reports any other number of elements. */
  record PoseLiteral(List<Expression> elements, SourceRange range) implements Expression {
    public PoseLiteral {
      elements = List.copyOf(elements);
    }
  }

  /** {@code [a, b, ...]}; a matrix is a list of lists of equal length. */
  record ListLiteral(List<Expression> elements, SourceRange range) implements Expression {
    public ListLiteral {
      elements = List.copyOf(elements);
    }
  }

  /** A variable. */
  record Name(String name, SourceRange range) implements Expression {}

  record Unary(UnaryOperator operator, Expression operand, SourceRange range)
      implements Expression {}

  record Binary(BinaryOperator operator, Expression left, Expression right, SourceRange range)
      implements Expression {}

  /** {@code function(arguments)}; {@code struct(...)} is one too. */
  record Call(String function, SourceRange nameRange, List<Argument> arguments, SourceRange range)
      implements Expression {
    public Call {
      arguments = List.copyOf(arguments);
    }
  }

  /** {@code receiver.method(arguments)}. */
  record MethodCall(
      Expression receiver,
      String method,
      SourceRange nameRange,
      List<Argument> arguments,
      SourceRange range)
      implements Expression {
    public MethodCall {
      arguments = List.copyOf(arguments);
    }
  }

  /** {@code receiver.member}. */
  record Member(Expression receiver, String member, SourceRange nameRange, SourceRange range)
      implements Expression {}

  /** {@code receiver[i]} or {@code receiver[i, j]}: one or two indices. */
  record Index(Expression receiver, List<Expression> indices, SourceRange range)
      implements Expression {
    public Index {
      indices = List.copyOf(indices);
    }
  }

  /** {@code run thread()}: starts a thread, its value is the handle. */
  record Run(String thread, SourceRange nameRange, List<Argument> arguments, SourceRange range)
      implements Expression {
    public Run {
      arguments = List.copyOf(arguments);
    }
  }
}
