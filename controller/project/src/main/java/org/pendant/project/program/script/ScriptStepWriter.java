package org.pendant.project.program.script;

import java.util.List;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.TemplateStep;

/** Step writer: writes nodes, each by the writer of its family. */
final class ScriptStepWriter {
  private final ScriptContext context;
  private final MotionWriter motion;
  private final ActionWriter action;
  private final FlowWriter flow;
  private final ForeignWriter foreign;
  private final TemplateWriter template;

  ScriptStepWriter(ScriptContext context) {
    this.context = context;
    motion = new MotionWriter(context, this);
    action = new ActionWriter(context, this, motion.tool());
    flow = new FlowWriter(context, this);
    foreign = new ForeignWriter(context);
    template = new TemplateWriter(context, this);
  }

  ScriptContext context() {
    return context;
  }

  /** Moves and places. */
  MotionWriter motion() {
    return motion;
  }

  /** Decisions and loops. */
  FlowWriter flow() {
    return flow;
  }

  /** Templates. */
  TemplateWriter template() {
    return template;
  }

  /** Nodes beside each other, in their order; suppressed ones generate nothing. */
  void writeAll(List<ProgramNode> nodes) {
    List<ProgramNode> active = nodes.stream().filter(each -> !each.suppressed()).toList();
    int i = 0;
    while (i < active.size()) {
      ProgramNode node = active.get(i);
      if (node.step() instanceof FlowStep.If) {
        int next = FlowWriter.endOfIf(active, i + 1);
        flow.writeIf(active.subList(i, next));
        i = next;
      } else {
        write(node);
        i++;
      }
    }
  }

  /** One node with all below it. */
  void write(ProgramNode node) {
    if (node.suppressed()) {
      return;
    }
    switch (node.step()) {
      // sections stand at the top only, where ProgramWriter writes them
      case Section _ -> {}
      case MotionStep step -> motion.write(node, step);
      case ActionStep step -> action.write(node, step);
      case FlowStep step -> flow.write(node, step);
      case TemplateStep step -> template.write(node, step);
      case ForeignStep step -> foreign.write(node, step);
    }
  }
}
