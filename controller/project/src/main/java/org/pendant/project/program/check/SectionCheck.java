package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.HashSet;
import java.util.Set;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;

/** Section check: checks the nodes at the top of a tree. */
final class SectionCheck {
  private final CheckContext findings;
  private final Set<NodeKind> single = new HashSet<>();
  private final Set<String> subPrograms = new HashSet<>();
  private boolean hasMain;

  SectionCheck(CheckContext findings) {
    this.findings = findings;
  }

  void check(ProgramNode node, Section section) {
    switch (section) {
      case Section.InitialValues initial -> {
        once(node);
        initial.values().forEach(each -> initialValue(node, each));
      }
      case Section.BeforeStart before -> once(node);
      case Section.MainProgram main -> {
        once(node);
        hasMain = true;
      }
      case Section.ThreadSection thread -> {
        if (thread.name().isBlank()) {
          findings.problem(node, "name", text("threadWithoutName"));
        }
      }
      case Section.Event event ->
          findings.expression(node, "condition", text("eventCondition"), event.condition());
      case Section.SubProgram sub -> subProgram(node, sub.name());
    }
  }

  private void once(ProgramNode node) {
    NodeKind kind = NodeKind.of(node.step());
    if (!single.add(kind)) {
      findings.problem(node, "", text("onlyOnce", kind.title()));
    }
  }

  private void initialValue(ProgramNode node, Section.InitialValue value) {
    findings.identifier(node, "values", text("variable"), value.variable());
    findings.expression(
        node, "values", text("initialValueOf", value.variable()), value.expression());
  }

  private void subProgram(ProgramNode node, String name) {
    if (name.isBlank()) {
      findings.problem(node, "name", text("subProgramWithoutName"));
    } else if (!subPrograms.add(name)) {
      findings.problem(node, "name", text("subProgramTwice", name));
    }
  }

  /** Whether a main program that runs has been seen. */
  boolean hasMain() {
    return hasMain;
  }
}
