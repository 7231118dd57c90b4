package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;
import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BoolLiteral;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.FloatLiteral;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.IntLiteral;
import org.pendant.language.syntax.Expression.ListLiteral;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.MethodCall;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.NoneLiteral;
import org.pendant.language.syntax.Expression.PoseLiteral;
import org.pendant.language.syntax.Expression.Run;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.language.syntax.Expression.Unary;

/**
 * Expression builder: turns ANTLR's expressions into ours: sorts the flat list of operators by
 * precedence and decides what the grammar leaves open (poses, named arguments, the size of
 * numbers).
 */
final class ExpressionBuilder {
  /** How deep a tree may be: code that walks it later does so recursively. */
  static final int MAX_DEPTH = 1000;

  private static final int NO_OPERATOR = 0;
  private static final int POSE_ELEMENTS = 6;
  private static final String MIN_INT_DIGITS = "2147483648";

  private final Source source;
  private final Complaints complaints;

  // How deep the expression is that was built last.
  private int depth;
  private boolean tooDeep;

  ExpressionBuilder(Source source, Complaints complaints) {
    this.source = source;
    this.complaints = complaints;
  }

  /** One whole expression. */
  Expression build(ExpressionContext context) {
    Operators operators = new Operators(context.children);
    return operators.next(NO_OPERATOR + 1);
  }

  /** The left side of an assignment, or a call. */
  Expression build(ReferenceContext context) {
    return postfix(context.children);
  }

  List<Argument> build(ArgumentsContext context) {
    List<Argument> arguments = new ArrayList<>(context.children.size() / 2);
    int deepest = 0;
    for (int i = 1; i < context.children.size() - 1; i += 2) {
      arguments.add(argument((ArgumentContext) context.children.get(i)));
      deepest = Math.max(deepest, depth);
    }
    depth = deepest;
    return arguments;
  }

  private Argument argument(ArgumentContext context) {
    Expression first = build((ExpressionContext) context.children.get(0));
    if (context.children.size() == 1) {
      return new Argument(Optional.empty(), first, range(context));
    }
    Expression value = build((ExpressionContext) context.children.get(2));
    SourceRange range = range(context);
    if (first instanceof Name name && first.range().equals(range(context.expression(0)))) {
      return new Argument(Optional.of(name.name()), value, range);
    }
    complaints.addAboutMeaning(
        "argument-name",
        first.range(),
        text("argumentNameIsNone", Wording.shortened(source.text(first.range()))));
    return new Argument(Optional.empty(), value, range);
  }

  /** Precedence climbing over {@code prefix* operand (operator prefix* operand)*}. */
  private final class Operators {
    private final List<ParseTree> parts;
    private int at;

    // What the expression read last covers, with the brackets around it that leave no node.
    private int start;
    private int end;

    Operators(List<ParseTree> parts) {
      this.parts = parts;
    }

    Expression next(int loosest) {
      Expression left = prefixed(loosest);
      int leftStart = start;
      int leftDepth = depth;
      while (at < parts.size()) {
        int type = type(parts.get(at));
        int precedence = OperatorTable.precedence(type);
        if (precedence < loosest) {
          break;
        }
        at++;
        Expression right = next(precedence + 1);
        leftDepth = Math.max(leftDepth, depth);
        if (allows(leftDepth, right.range())) {
          left =
              new Binary(
                  OperatorTable.operator(type), left, right, new SourceRange(leftStart, end));
          leftDepth++;
        }
      }
      start = leftStart;
      depth = leftDepth;
      return left;
    }

    private Expression prefixed(int loosest) {
      ParseTree part = parts.get(at++);
      if (!(part instanceof TerminalNode sign)) {
        return operand((OperandContext) part);
      }
      int type = sign.getSymbol().getType();
      SourceRange signRange = range(sign);
      if ((type == MINUS || type == LINE_MINUS) && isSmallestInt(parts.get(at))) {
        SourceRange digits = range((TerminalNode) parts.get(at++).getChild(0));
        start = signRange.start();
        end = digits.end();
        depth = 1;
        return new IntLiteral(Integer.MIN_VALUE, signRange.to(digits));
      }
      // On the right of a tighter operator `not` takes only what that operator would take.
      Expression operand =
          next(
              type == NOT || type == BANG
                  ? Math.max(OperatorTable.PRECEDENCE_OF_NOT, loosest)
                  : OperatorTable.PRECEDENCE_OF_SIGN);
      start = signRange.start();
      depth++;
      return new Unary(OperatorTable.unary(type), operand, new SourceRange(start, end));
    }

    private Expression operand(OperandContext context) {
      Expression operand = postfix(context.children);
      start = context.getStart().getStartIndex();
      end = context.getStop().getStopIndex() + 1;
      return operand;
    }
  }

  private static boolean isSmallestInt(ParseTree operand) {
    return operand instanceof OperandContext context
        && context.children.size() == 1
        && context.children.getFirst() instanceof TerminalNode number
        && number.getSymbol().getType() == INT
        && number.getText().equals(MIN_INT_DIGITS);
  }

  private Expression postfix(List<ParseTree> parts) {
    TerminalNode first = (TerminalNode) parts.getFirst();
    int type = first.getSymbol().getType();
    SourceRange firstRange = range(first);
    int next = 1;
    depth = 1;
    Expression result;
    switch (type) {
      case NAME -> {
        String name = source.text(firstRange);
        if (parts.size() > 1 && parts.get(1) instanceof ArgumentsContext arguments) {
          List<Argument> built = build(arguments);
          depth++;
          result = new Call(name, firstRange, built, firstRange.to(range(arguments)));
          next = 2;
        } else if (name.equals("p") && isPose(parts)) {
          SuffixContext suffix = (SuffixContext) parts.get(1);
          result = new PoseLiteral(elements(suffix.children), firstRange.to(range(suffix)));
          next = 2;
        } else {
          result = new Name(name, firstRange);
        }
      }
      case RUN -> {
        SourceRange nameRange = range((TerminalNode) parts.get(1));
        ArgumentsContext arguments = (ArgumentsContext) parts.get(2);
        List<Argument> built = build(arguments);
        depth++;
        result = new Run(source.text(nameRange), nameRange, built, firstRange.to(range(arguments)));
        next = 3;
      }
      case LPAREN, LINE_LPAREN -> {
        result = build((ExpressionContext) parts.get(1));
        next = 3;
      }
      case LBRACK, LINE_LBRACK -> {
        int close = closingBracket(parts);
        result =
            new ListLiteral(
                elements(parts.subList(0, close + 1)),
                firstRange.to(range((TerminalNode) parts.get(close))));
        next = close + 1;
      }
      default -> result = literal(type, firstRange);
    }
    for (int i = next; i < parts.size(); i++) {
      int receiverDepth = depth;
      Expression longer = suffix(result, firstRange, (SuffixContext) parts.get(i));
      depth = Math.max(receiverDepth, depth);
      if (allows(depth, firstRange)) {
        result = longer;
        depth++;
      }
    }
    return result;
  }

  private static int closingBracket(List<ParseTree> parts) {
    int at = 1;
    while (type(parts.get(at)) != RBRACK) {
      at++;
    }
    return at;
  }

  /** {@code p[...]} is a pose unless one or two elements make it an index into a variable. */
  private boolean isPose(List<ParseTree> parts) {
    if (parts.size() < 2 || type(parts.get(1).getChild(0)) != LBRACK) {
      return false;
    }
    SuffixContext suffix = (SuffixContext) parts.get(1);
    int count = suffix.expression().size();
    if (count == POSE_ELEMENTS) {
      return true;
    }
    if (count == 1 || count == 2) {
      return false;
    }
    complaints.addAboutMeaning(
        "pose-elements",
        range((TerminalNode) parts.getFirst()).to(range(suffix)),
        text("poseElements", count));
    return true;
  }

  /** What stands between a bracket and its partner, commas between. */
  private List<Expression> elements(List<ParseTree> parts) {
    List<Expression> elements = new ArrayList<>(parts.size() / 2);
    int deepest = 0;
    for (int i = 1; i < parts.size() - 1; i += 2) {
      elements.add(build((ExpressionContext) parts.get(i)));
      deepest = Math.max(deepest, depth);
    }
    depth = deepest + 1;
    return elements;
  }

  private Expression suffix(Expression receiver, SourceRange start, SuffixContext context) {
    SourceRange range = start.to(range(context));
    if (type(context.children.getFirst()) == DOT) {
      SourceRange nameRange = range((TerminalNode) context.children.get(1));
      String name = source.text(nameRange);
      depth = 0;
      return context.children.size() == 2
          ? new Member(receiver, name, nameRange, range)
          : new MethodCall(
              receiver, name, nameRange, build((ArgumentsContext) context.children.get(2)), range);
    }
    List<Expression> indices = elements(context.children);
    if (indices.isEmpty() || indices.size() > 2) {
      complaints.addAboutMeaning("index-count", range(context), text("indexCount", indices.size()));
    }
    return new Index(receiver, indices, range);
  }

  private Expression literal(int type, SourceRange range) {
    return switch (type) {
      case INT -> wholeNumber(range);
      case FLOAT -> new FloatLiteral(Double.parseDouble(source.text(range)), range);
      case TRUE, FALSE -> new BoolLiteral(type == TRUE, range);
      case STRING -> new StringLiteral(unquoted(range), range);
      default -> new NoneLiteral(range);
    };
  }

  private String unquoted(SourceRange range) {
    String text = source.text(range);
    // A string that lost its closing quote has been reported and is here only for the tree.
    boolean closed = text.length() > 1 && text.charAt(text.length() - 1) == text.charAt(0);
    return text.substring(1, closed ? text.length() - 1 : text.length());
  }

  /** An int, or a float if it does not fit one. */
  private Expression wholeNumber(SourceRange range) {
    String text = source.text();
    long value = 0;
    for (int i = range.start(); i < range.end(); i++) {
      value = value * 10 + (text.charAt(i) - '0');
      if (value > Integer.MAX_VALUE) {
        return new FloatLiteral(Double.parseDouble(source.text(range)), range);
      }
    }
    return new IntLiteral((int) value, range);
  }

  /** Whether a node may stand on {@code inner} levels of others; complains once if not. */
  private boolean allows(int inner, SourceRange where) {
    if (inner < MAX_DEPTH) {
      return true;
    }
    complaints.note(where);
    if (!tooDeep) {
      tooDeep = true;
      complaints.addAboutMeaning("nested-too-deeply", where, text("expressionTooDeep", MAX_DEPTH));
    }
    return false;
  }

  private static int type(ParseTree part) {
    return part instanceof TerminalNode terminal ? terminal.getSymbol().getType() : NO_OPERATOR;
  }

  static SourceRange range(TerminalNode terminal) {
    return ((ScriptToken) terminal.getSymbol()).range();
  }

  static SourceRange range(ParserRuleContext context) {
    return new SourceRange(
        context.getStart().getStartIndex(), context.getStop().getStopIndex() + 1);
  }
}
