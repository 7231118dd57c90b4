package org.pendant.project.program.script;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Signature;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.StepCode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.WaitFor;

/** Which nodes let robot time pass: an endless loop without any must be given a wait. */
final class Waits {
  private static final Pattern WORD = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  /** Functions that wait, and the words that end something. */
  private static final Set<String> WAITING =
      Stream.concat(
              StandardBuiltins.create().all().stream()
                  .filter(Signature::physicalTime)
                  .map(Signature::name),
              Stream.of("halt", "join", "pause"))
          .collect(Collectors.toUnmodifiableSet());

  private final TreeSurvey survey;
  private final Set<String> called = new HashSet<>();

  private Waits(TreeSurvey survey) {
    this.survey = survey;
  }

  /** Whether any of the nodes, or what they call, may wait. */
  static boolean among(List<ProgramNode> nodes, TreeSurvey survey) {
    return new Waits(survey).any(nodes);
  }

  private boolean any(List<ProgramNode> nodes) {
    return nodes.stream().anyMatch(each -> !each.suppressed() && waits(each));
  }

  private boolean waits(ProgramNode node) {
    if (StepCode.of(node.step()).stream().anyMatch(Waits::inCode)) {
      return true;
    }
    return switch (node.step()) {
      case MotionStep.Move _, MotionStep.Until _ -> any(node.children());
      case MotionStep _ -> true;
      case ActionStep.Wait wait -> !(wait.what() instanceof WaitFor.Nothing);
      case ActionStep.SetAction set -> set.setting() instanceof Setting.Pulse;
      case ActionStep.Popup _, ActionStep.Halt _, ActionStep.OperatorInput _ -> true;
      case ActionStep.Call call -> inCalled(call.subProgram());
      case ActionStep _ -> any(node.children());
      case FlowStep.If each -> each.continuously() || any(node.children());
      case FlowStep.Loop loop -> inLoop(loop.rule()) || any(node.children());
      case FlowStep _ -> any(node.children());
      case TemplateStep.Part _ -> any(node.children());
      case TemplateStep _ -> true;
      case ForeignStep _, Section _ -> false;
    };
  }

  private static boolean inLoop(LoopRule rule) {
    return switch (rule) {
      case LoopRule.Forever _ -> true;
      case LoopRule.Times _ -> false;
      case LoopRule.While each -> each.continuously();
    };
  }

  private boolean inCalled(String subProgram) {
    ProgramNode found = survey.subPrograms().get(subProgram);
    return found != null && called.add(subProgram) && any(found.children());
  }

  private static boolean inCode(String code) {
    for (Matcher word = WORD.matcher(code); word.find(); ) {
      if (WAITING.contains(word.group())) {
        return true;
      }
    }
    return false;
  }
}
