package org.pendant.project.program.check;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;

/**
 * Flow check: checks nodes that decide what runs, and the order in which those stand beside each
 * other.
 */
final class FlowCheck {
  private final CheckContext findings;

  FlowCheck(CheckContext findings) {
    this.findings = findings;
  }

  void check(ProgramNode node, FlowStep step) {
    switch (step) {
      case FlowStep.If condition ->
          findings.expression(node, "condition", "condition", condition.condition());
      case FlowStep.ElseIf condition ->
          findings.expression(node, "condition", "condition", condition.condition());
      case FlowStep.Else _, FlowStep.DefaultCase _ -> {}
      case FlowStep.Loop loop -> loop(node, loop.rule());
      case FlowStep.Switch choice -> {
        findings.expression(node, "expression", "value", choice.expression());
        cases(node);
      }
      case FlowStep.Case one -> {
        if (one.number().isEmpty()) {
          findings.problem(
              node,
              "value",
              one.value().isBlank()
                  ? "the value of the case is missing, expected a number"
                  : "'" + one.value() + "' is no number");
        }
      }
    }
  }

  private void loop(ProgramNode node, LoopRule rule) {
    switch (rule) {
      case LoopRule.Forever _ -> {}
      case LoopRule.Times times -> {
        findings.expression(node, "rule", "number of turns", times.count());
        if (times.number().orElse(0) < 0) {
          findings.problem(
              node,
              "rule",
              "the number of turns is " + times.count().strip() + ", must not be negative");
        }
        if (!times.variable().isEmpty()) {
          findings.identifier(node, "rule", "counting variable", times.variable());
        }
      }
      case LoopRule.While condition ->
          findings.expression(node, "rule", "condition", condition.condition());
    }
  }

  private void cases(ProgramNode node) {
    Set<Double> values = new HashSet<>();
    boolean hasDefault = false;
    for (ProgramNode each : MotionCheck.running(node)) {
      if (each.step() instanceof FlowStep.Case one) {
        if (one.number().isPresent() && !values.add(one.number().getAsDouble())) {
          findings.problem(each, "value", "there is another case " + one.value());
        }
      } else if (each.step() instanceof FlowStep.DefaultCase) {
        if (hasDefault) {
          findings.problem(each, "", "a Switch has only one Default");
        }
        hasDefault = true;
      }
    }
    if (MotionCheck.running(node).stream()
        .noneMatch(each -> each.step() instanceof FlowStep.Case)) {
      findings.problem(node, "", "the Switch is empty, expected a Case below it");
    }
  }

  /** ElseIf and Else follow an If directly. */
  void order(List<ProgramNode> siblings) {
    boolean open = false;
    for (ProgramNode each : siblings) {
      if (each.suppressed()) {
        continue;
      }
      switch (each.step()) {
        case FlowStep.If _ -> open = true;
        case FlowStep.ElseIf _ -> {
          if (!open) {
            findings.problem(each, "", "ElseIf stands directly behind an If or ElseIf");
          }
        }
        case FlowStep.Else _ -> {
          if (!open) {
            findings.problem(each, "", "Else stands directly behind an If or ElseIf");
          }
          open = false;
        }
        default -> open = false;
      }
    }
  }
}
