package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

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
          findings.expression(node, "condition", text("condition"), condition.condition());
      case FlowStep.ElseIf condition ->
          findings.expression(node, "condition", text("condition"), condition.condition());
      case FlowStep.Else _, FlowStep.DefaultCase _ -> {}
      case FlowStep.Loop loop -> loop(node, loop.rule());
      case FlowStep.Switch choice -> {
        findings.expression(node, "expression", text("value"), choice.expression());
        cases(node);
      }
      case FlowStep.Case one -> {
        if (one.number().isEmpty()) {
          findings.problem(
              node,
              "value",
              one.value().isBlank() ? text("caseMissing") : text("caseNoNumber", one.value()));
        }
      }
    }
  }

  private void loop(ProgramNode node, LoopRule rule) {
    switch (rule) {
      case LoopRule.Forever _ -> {}
      case LoopRule.Times times -> {
        findings.expression(node, "rule", text("turns"), times.count());
        if (times.number().orElse(0) < 0) {
          findings.problem(node, "rule", text("negativeTurns", times.count().strip()));
        }
        if (!times.variable().isEmpty()) {
          findings.identifier(node, "rule", text("countingVariable"), times.variable());
        }
      }
      case LoopRule.While condition ->
          findings.expression(node, "rule", text("condition"), condition.condition());
    }
  }

  private void cases(ProgramNode node) {
    Set<Double> values = new HashSet<>();
    boolean hasDefault = false;
    for (ProgramNode each : MotionCheck.running(node)) {
      if (each.step() instanceof FlowStep.Case one) {
        if (one.number().isPresent() && !values.add(one.number().getAsDouble())) {
          findings.problem(each, "value", text("caseTwice", one.value()));
        }
      } else if (each.step() instanceof FlowStep.DefaultCase) {
        if (hasDefault) {
          findings.problem(each, "", text("defaultTwice"));
        }
        hasDefault = true;
      }
    }
    if (MotionCheck.running(node).stream()
        .noneMatch(each -> each.step() instanceof FlowStep.Case)) {
      findings.problem(node, "", text("switchEmpty"));
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
            findings.problem(each, "", text("elseIfWithoutIf"));
          }
        }
        case FlowStep.Else _ -> {
          if (!open) {
            findings.problem(each, "", text("elseWithoutIf"));
          }
          open = false;
        }
        default -> open = false;
      }
    }
  }
}
