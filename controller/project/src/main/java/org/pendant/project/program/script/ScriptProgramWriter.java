package org.pendant.project.program.script;

import java.util.ArrayList;
import java.util.List;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.TreeNames;

/**
 * Program writer: writes a program as a whole: the sections of the tree, and what they need around
 * them.
 */
final class ScriptProgramWriter {
  private final ScriptContext context;
  private final ScriptLines lines;
  private final ScriptNames names;
  private final ScriptStepWriter steps;
  private final List<ProgramNode> sections;

  ScriptProgramWriter(ScriptContext context) {
    this.context = context;
    lines = context.lines();
    names = context.names();
    steps = new ScriptStepWriter(context);
    sections = context.tree().sections().stream().filter(each -> !each.suppressed()).toList();
  }

  /** All of it. */
  void write() {
    lines.open("def " + context.program() + "():");
    new Preamble(context).write();
    steps.template().variables();
    for (ProgramNode section : sections) {
      if (section.step() instanceof Section.InitialValues initial) {
        initialValues(section, initial);
      }
    }
    // sub programs and threads may have nodes that need it
    context.control().ifPresent(control -> lines.received(control.header()));
    timers();
    subPrograms();
    for (ProgramNode section : sections) {
      if (section.step() instanceof Section.BeforeStart) {
        lines.begin(section, ScriptLines.NO_BREAK);
        steps.writeAll(section.children());
        lines.end();
      }
    }
    for (ProgramNode section : sections) {
      if (section.step() instanceof Section.ThreadSection thread) {
        thread(section, thread);
      }
    }
    events();
    for (ProgramNode section : sections) {
      if (section.step() instanceof Section.MainProgram main) {
        lines.begin(section);
        body(section, main.forever());
        lines.end();
      }
    }
    lines.close();
  }

  private void initialValues(ProgramNode node, Section.InitialValues initial) {
    lines.begin(node);
    for (Section.InitialValue each : initial.values()) {
      if (!each.variable().isBlank() && !each.expression().isBlank()) {
        lines.line(
            "global "
                + names.variable(each.variable())
                + " = "
                + ScriptText.oneLine(each.expression().strip()));
      }
    }
    lines.end();
  }

  private void body(ProgramNode section, boolean forever) {
    if (forever) {
      steps.flow().repeat(section);
    } else {
      steps.writeAll(section.children());
    }
  }

  private void subPrograms() {
    for (ProgramNode section : sections) {
      if (section.step() instanceof Section.SubProgram sub
          && context.survey().isCalled(sub.name(), section)) {
        lines.open("def " + names.function(sub.name()) + "():");
        apart(section, false, ScriptLines.NO_BREAK);
        lines.close();
      }
    }
  }

  /** The children of a section in a function or thread of its own. */
  private void apart(ProgramNode section, boolean forever, String... marks) {
    lines.begin(section, marks);
    body(section, forever);
    lines.end();
  }

  /** One thread counts the time of all stop watches. */
  private void timers() {
    List<String> timers = new ArrayList<>(context.survey().timers());
    timers.removeIf(String::isBlank);
    if (timers.isEmpty()) {
      return;
    }
    for (String timer : timers) {
      if (!hasInitialValue(timer)) {
        lines.line("global " + names.variable(timer) + " = 0.0");
      }
      lines.line("global " + context.counting(timer) + " = False");
    }
    String thread = names.unique("Timer_Thread", "Timer_Thread");
    lines.open("thread " + thread + "():");
    lines.open(ScriptLines.ENDLESS);
    for (String timer : timers) {
      String name = names.variable(timer);
      lines.open("if (" + context.counting(timer) + "):");
      lines.line(name + " = " + name + " + get_steptime()");
      lines.close();
    }
    lines.line("sync()");
    lines.close();
    lines.close();
    // nobody stops it
    lines.line("run " + thread + "()");
  }

  private boolean hasInitialValue(String variable) {
    return sections.stream()
        .map(ProgramNode::step)
        .filter(Section.InitialValues.class::isInstance)
        .flatMap(each -> ((Section.InitialValues) each).values().stream())
        .anyMatch(each -> each.variable().equals(variable) && !each.expression().isBlank());
  }

  private void start(String thread) {
    start(thread, names.unique("threadId_" + thread, "threadId"));
  }

  private void start(String thread, String handle) {
    lines.line(handle + " = run " + thread + "()");
  }

  private void thread(ProgramNode section, Section.ThreadSection step) {
    String thread = names.unique(step.name(), "Thread");
    lines.open("thread " + thread + "():");
    apart(section, step.forever());
    lines.close();
    start(thread, names.handle("threadId_" + TreeNames.word(step.name(), thread)));
  }

  /** One thread watches all events. */
  private void events() {
    List<ProgramNode> events =
        sections.stream().filter(each -> each.step() instanceof Section.Event).toList();
    if (events.isEmpty()) {
      return;
    }
    List<String> held = events.stream().map(_ -> names.numbered("event_held")).toList();
    held.forEach(flag -> lines.line("global " + flag + " = False"));
    String thread = names.unique("Event_Thread", "Event_Thread");
    lines.open("thread " + thread + "():");
    lines.open(ScriptLines.ENDLESS);
    for (int i = 0; i < events.size(); i++) {
      event(events.get(i), held.get(i));
    }
    lines.line("sync()");
    lines.close();
    lines.close();
    start(thread);
  }

  private void event(ProgramNode node, String held) {
    if (!(node.step() instanceof Section.Event event)) {
      return;
    }
    lines.begin(node);
    lines.open("if " + ScriptText.condition(event.condition()) + ":");
    lines.open("if (not(" + held + ")):");
    lines.line(held + " = True");
    steps.writeAll(node.children());
    lines.close();
    lines.between("else:");
    lines.line(held + " = False");
    lines.close();
    lines.end();
  }
}
