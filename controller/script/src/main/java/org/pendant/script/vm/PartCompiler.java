package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;

/**
 * Part compiler: compiles the path to a part of a variable that is changed in its place: first what
 * says which part it is, then, with nothing in between that could change the variable, the opening
 * of one container after the other.
 */
final class PartCompiler {
  /** One step from a container to a part: what opens it, and the index or name. */
  record Step(SourceRange range, int operation, int operand) {}

  /**
   * A part of a variable.
   *
   * @param root the operand of the variable
   */
  record Part(int root, List<Step> steps) {
    Part {
      steps = List.copyOf(steps);
    }
  }

  /**
   * A part that is open.
   *
   * @param operand where it is
   * @param parent where the container is that it was opened in; itself if that is a variable
   */
  record Opened(int operand, int parent) {}

  private final FunctionContext context;
  private final ExpressionCompiler expressions;
  private final CodeBuilder code;

  PartCompiler(FunctionContext context, ExpressionCompiler expressions) {
    this.context = context;
    this.expressions = expressions;
    code = context.code();
  }

  /**
   * Evaluates which part {@code expression} is.
   *
   * @param variable the operand of the variable that it is a part of
   * @param after what is evaluated between this and the opening
   */
  Part part(Expression expression, int variable, List<Expression> after) {
    List<Step> steps = new ArrayList<>();
    int root = collect(expression, variable, after, steps);
    return new Part(root, steps);
  }

  private int collect(
      Expression expression, int variable, List<Expression> after, List<Step> steps) {
    return switch (expression) {
      case Index index when index.indices().size() == 1 -> {
        List<Expression> later = new ArrayList<>(index.indices());
        later.addAll(after);
        int root = collect(index.receiver(), variable, later, steps);
        int operand = kept(index.indices().getFirst(), after);
        steps.add(new Step(index.range(), Op.OPEN_INDEX, operand));
        yield root;
      }
      case Member member -> {
        int root = collect(member.receiver(), variable, after, steps);
        int name = context.linkage().name(member.member());
        steps.add(new Step(member.range(), Op.OPEN_MEMBER, name));
        yield root;
      }
      case Expression.Name name -> variable;
      default -> expressions.part(expression, true);
    };
  }

  /** The operand of an index, with the value that it has now whatever is evaluated after it. */
  private int kept(Expression index, List<Expression> after) {
    int operand = expressions.operand(index);
    if (index instanceof Expression.Name
        && after.stream().anyMatch(ConstantValues::callsSomething)) {
      int copy = Instruction.local(context.temporary());
      code.at(index.range());
      code.emit(Op.MOVE, copy, operand, 0);
      return copy;
    }
    return operand;
  }

  /** Opens the containers on the way to a part, and the part itself. */
  Opened open(Part part) {
    int parent = part.root();
    int operand = part.root();
    for (Step step : part.steps()) {
      int next = Instruction.local(context.temporary());
      code.at(step.range());
      code.emit(step.operation(), next, operand, step.operand());
      parent = operand;
      operand = next;
    }
    return new Opened(operand, parent);
  }

  /**
   * Puts a part back that may be another object now: a pose is replaced, not changed, so what holds
   * it takes the new one.
   */
  void putBack(Part part, Opened opened) {
    if (!part.steps().isEmpty()) {
      Step last = part.steps().getLast();
      int operation = last.operation() == Op.OPEN_INDEX ? Op.SET_INDEX : Op.SET_MEMBER;
      code.emit(operation, opened.parent(), last.operand(), opened.operand());
    }
  }
}
