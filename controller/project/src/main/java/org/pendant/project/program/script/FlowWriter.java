package org.pendant.project.program.script;

import java.util.List;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;

/** Flow writer: writes decisions and loops. */
final class FlowWriter {
  /** So many alternatives stand inside of each other; the language has a limit for open blocks. */
  private static final int MAX_NESTED = 12;

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final ScriptNames names;

  FlowWriter(ScriptContext context, ScriptStepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    names = context.names();
  }

  /** Where the alternatives end that follow an If: the first place that is none. */
  static int endOfIf(List<ProgramNode> nodes, int from) {
    int end = from;
    while (end < nodes.size()
        && (nodes.get(end).step() instanceof FlowStep.ElseIf
            || nodes.get(end).step() instanceof FlowStep.Else)) {
      end++;
    }
    return end;
  }

  /** A node that is no If with all below it. */
  void write(ProgramNode node, FlowStep step) {
    switch (step) {
      case FlowStep.If _ -> writeIf(List.of(node));
      case FlowStep.ElseIf _, FlowStep.Else _ -> remark(node, "an If must stand before this");
      case FlowStep.Loop loop -> writeLoop(node, loop.rule());
      case FlowStep.Switch each -> writeSwitch(node, each);
      case FlowStep.Case _, FlowStep.DefaultCase _ ->
          remark(node, "a Switch must stand above this");
    }
  }

  /** An If with the alternatives beside it. */
  void writeIf(List<ProgramNode> chain) {
    ProgramNode first = chain.getFirst();
    List<ProgramNode> others = chain.subList(1, chain.size());
    if (!(first.step() instanceof FlowStep.If step)) {
      return;
    }
    if (step.continuously()) {
      writeContinuousIf(first, step.condition(), others);
      return;
    }
    lines.begin(first);
    lines.open("if " + ScriptText.condition(step.condition()) + ":");
    steps.writeAll(first.children());
    lines.end();
    writeOthers(others);
    lines.close();
  }

  /** The alternatives of an if that is open; after it is still open. */
  private void writeOthers(List<ProgramNode> others) {
    boolean nested = others.size() <= MAX_NESTED;
    int open = 0;
    for (int i = 0; i < others.size(); i++) {
      ProgramNode other = others.get(i);
      if (other.step() instanceof FlowStep.ElseIf each) {
        if (each.continuously()) {
          lines.between("else:");
          writeContinuousIf(other, each.condition(), others.subList(i + 1, others.size()));
          break;
        }
        String head = "if " + ScriptText.condition(each.condition()) + ":";
        if (nested) {
          lines.between("else:");
          lines.begin(other);
          lines.open(head);
          open++;
        } else {
          lines.between("el" + head);
          lines.begin(other, ScriptLines.NO_BREAK);
        }
      } else {
        lines.between("else:");
        lines.begin(other, ScriptLines.NO_BREAK);
      }
      steps.writeAll(other.children());
      lines.end();
      if (other.step() instanceof FlowStep.Else) {
        break;
      }
    }
    for (int i = 0; i < open; i++) {
      lines.close();
    }
  }

  /**
   * The children run in a thread of their own, which is killed when the condition holds no more.
   * The alternatives are tried as well when it is.
   */
  private void writeContinuousIf(ProgramNode node, String condition, List<ProgramNode> others) {
    String number = "_" + lines.number(node);
    String flag = names.unique("thread_flag" + number, "thread_flag");
    String handle = names.unique("thread_handler" + number, "thread_handler");
    String thread = names.unique("Thread_if" + number, "Thread_if");
    String holds = ScriptText.condition(condition);
    lines.begin(node);
    lines.line("global " + flag + " = 0");
    lines.open("thread " + thread + "():");
    steps.writeAll(node.children());
    lines.line(flag + " = 1");
    lines.close();
    lines.open("if " + holds + ":");
    lines.line("global " + handle + " = run " + thread + "()");
    lines.open("while (" + flag + " == 0):");
    lines.open("if not" + holds + ":");
    lines.line("kill " + handle);
    lines.line(flag + " = 2");
    lines.between("else:");
    lines.line("sync()");
    lines.close();
    lines.close();
    lines.between("else:");
    lines.line(flag + " = 2");
    lines.close();
    lines.end();
    if (!others.isEmpty()) {
      lines.open("if (" + flag + " == 2):");
      writeFirstOther(others);
      lines.close();
    }
  }

  /** The alternatives, the first of which needs no else. */
  private void writeFirstOther(List<ProgramNode> others) {
    ProgramNode first = others.getFirst();
    List<ProgramNode> rest = others.subList(1, others.size());
    if (!(first.step() instanceof FlowStep.ElseIf each)) {
      lines.begin(first, ScriptLines.NO_BREAK);
      steps.writeAll(first.children());
      lines.end();
    } else if (each.continuously()) {
      writeContinuousIf(first, each.condition(), rest);
    } else {
      lines.begin(first);
      lines.open("if " + ScriptText.condition(each.condition()) + ":");
      steps.writeAll(first.children());
      lines.end();
      writeOthers(rest);
      lines.close();
    }
  }

  private void writeLoop(ProgramNode node, LoopRule rule) {
    lines.begin(node);
    switch (rule) {
      case LoopRule.Forever _ -> repeat(node);
      case LoopRule.Times times -> writeTimes(node, times);
      case LoopRule.While each when each.continuously() ->
          writeContinuousLoop(node, ScriptText.condition(each.condition()));
      case LoopRule.While each when each.condition().strip().equals("True") -> repeat(node);
      case LoopRule.While each -> {
        lines.open("while " + ScriptText.condition(each.condition()) + ":");
        steps.writeAll(node.children());
        lines.close();
      }
    }
    lines.end();
  }

  /** A loop without end around the children of a node; whether it waits is up to these. */
  void repeat(ProgramNode node) {
    lines.open(ScriptLines.ENDLESS);
    steps.writeAll(node.children());
    lines.close();
  }

  private void writeTimes(ProgramNode node, LoopRule.Times times) {
    String counter =
        times.variable().isBlank() ? context.counter(node) : names.variable(times.variable());
    String count = ScriptText.oneLine(times.count().strip());
    lines.line(counter + " = 0");
    lines.open("while (" + counter + " < " + (count.isEmpty() ? "0" : operand(count)) + "):");
    steps.writeAll(node.children());
    lines.last(counter + " = " + counter + " + 1");
    lines.close();
  }

  /** In parentheses where what stands beside it could change its meaning. */
  private static String operand(String expression) {
    return expression.matches("\\w+|\\w+\\([\\w, ]*\\)") ? expression : "(" + expression + ")";
  }

  private void writeContinuousLoop(ProgramNode node, String holds) {
    String number = "_" + lines.number(node);
    String thread = names.unique("Thread_while" + number, "Thread_while");
    String handle = names.unique("thread_handler" + number, "thread_handler");
    lines.aside(
        () -> {
          lines.open("thread " + thread + "():");
          repeat(node);
          lines.close();
        });
    lines.open("if " + holds + ":");
    lines.line("global " + handle + " = run " + thread + "()");
    lines.open("while " + holds + ":");
    lines.line("sync()");
    lines.close();
    lines.line("kill " + handle);
    lines.close();
  }

  private void writeSwitch(ProgramNode node, FlowStep.Switch step) {
    String value = names.numbered("switch");
    lines.begin(node);
    List<ProgramNode> parts = node.children().stream().filter(each -> !each.suppressed()).toList();
    List<ProgramNode> cases =
        parts.stream().filter(each -> each.step() instanceof FlowStep.Case).toList();
    List<ProgramNode> defaults =
        parts.stream().filter(each -> each.step() instanceof FlowStep.DefaultCase).toList();
    if (!step.expression().isBlank()) {
      lines.line(value + " = " + ScriptText.oneLine(step.expression().strip()));
      writeCases(value, cases, defaults);
    }
    lines.end();
  }

  private void writeCases(String value, List<ProgramNode> cases, List<ProgramNode> defaults) {
    boolean open = false;
    for (ProgramNode each : cases) {
      if (!(each.step() instanceof FlowStep.Case one) || one.value().isBlank()) {
        continue;
      }
      String head =
          "if (" + operand(ScriptText.oneLine(one.value().strip())) + " == " + value + "):";
      if (open) {
        lines.between("el" + head);
      } else {
        lines.open(head);
      }
      open = true;
      lines.begin(each, ScriptLines.NO_BREAK);
      steps.writeAll(each.children());
      lines.end();
    }
    if (!defaults.isEmpty()) {
      if (open) {
        lines.between("else:");
      }
      lines.begin(defaults.getFirst(), ScriptLines.NO_BREAK);
      steps.writeAll(defaults.getFirst().children());
      lines.end();
    }
    if (open) {
      lines.close();
    }
  }

  private void remark(ProgramNode node, String text) {
    lines.begin(node, ScriptLines.NO_BREAK);
    lines.line("# " + text);
    lines.end();
  }
}
