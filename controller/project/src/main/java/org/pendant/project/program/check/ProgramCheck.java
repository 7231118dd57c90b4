package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.Placement;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.script.function.Builtins;

/**
 * Program check: finds everything that keeps a tree from running, at the node and field where
 * people can change it. Suppressed nodes are not looked at. Pure; any thread may call it.
 */
public final class ProgramCheck {
  private final CheckContext findings;
  private final SectionCheck sections;
  private final MotionCheck motion;
  private final ActionCheck action;
  private final FlowCheck flow;
  private final TemplateCheck template;

  private ProgramCheck(CheckContext findings) {
    this.findings = findings;
    SignalCheck signals = new SignalCheck(findings);
    sections = new SectionCheck(findings);
    motion = new MotionCheck(findings, signals);
    action = new ActionCheck(findings, signals);
    flow = new FlowCheck(findings);
    template = new TemplateCheck(findings, signals, motion);
  }

  /** What is wrong with a tree, in the order of its nodes; remarks among it. */
  public static List<NodeProblem> problems(ProgramTree tree, Installation installation) {
    return problems(tree, installation, StandardBuiltins.create());
  }

  /** As {@link #problems(ProgramTree, Installation)}, with a catalogue that is there already. */
  public static List<NodeProblem> problems(
      ProgramTree tree, Installation installation, Builtins<?> builtins) {
    CheckContext findings = new CheckContext(tree, installation, builtins);
    new ProgramCheck(findings).tree();
    new ExpressionValidator(findings, builtins).check();
    new ScriptCheck(findings, builtins).check();
    return inOrder(findings);
  }

  private static List<NodeProblem> inOrder(CheckContext findings) {
    Map<Long, Integer> places = new HashMap<>();
    findings.tree().forEach(node -> places.put(node.key(), places.size()));
    return findings.problems().stream()
        .sorted(Comparator.comparingInt(each -> places.getOrDefault(each.key(), 0)))
        .toList();
  }

  private void tree() {
    List<ProgramNode> top = findings.tree().sections();
    for (ProgramNode node : top) {
      if (node.suppressed()) {
        continue;
      }
      if (node.step() instanceof Section section) {
        sections.check(node, section);
      } else {
        findings.problem(node, "", text("notAtTop", NodeKind.of(node.step()).title()));
      }
      below(node, Optional.empty());
    }
    if (!sections.hasMain()) {
      findings.problem(ProgramTree.ROOT, "", text("noMain"));
    }
  }

  private void below(ProgramNode parent, Optional<MotionStep.Move> move) {
    flow.order(parent.children());
    for (ProgramNode node : parent.children()) {
      if (!node.suppressed()) {
        placement(parent.step(), node, move);
        step(node, move);
        below(node, node.step() instanceof MotionStep.Move own ? Optional.of(own) : move);
      }
    }
  }

  /**
   * What belongs to a move may also stand deeper below it, and a move in a move, as some programs
   * of others have it.
   */
  private void placement(Step parent, ProgramNode node, Optional<MotionStep.Move> move) {
    boolean deeper =
        move.isPresent()
            && Placement.allows(move.get(), node.step())
            && Placement.allows(parent, new ActionStep.Halt());
    boolean inMove = parent instanceof MotionStep.Move && node.step() instanceof MotionStep.Move;
    if (!deeper && !inMove && !(parent instanceof ForeignStep)) {
      Placement.whyNot(parent, node.step()).ifPresent(reason -> findings.problem(node, "", reason));
    }
  }

  private void step(ProgramNode node, Optional<MotionStep.Move> move) {
    switch (node.step()) {
      // what it is doing there has been reported
      case Section _ -> {}
      case MotionStep step -> motion.check(node, step, move);
      case ActionStep step -> action.check(node, step);
      case FlowStep step -> flow.check(node, step);
      case TemplateStep step -> template.check(node, step);
      case ForeignStep.Contributed contributed -> {
        if (contributed.stub().isEmpty() && !ExternalControl.is(contributed)) {
          findings.remark(node, text("urcapWithoutStub"));
        }
      }
      case ForeignStep.Unknown unknown ->
          findings.remark(node, text("unknownNode", unknown.element()));
    }
  }
}
