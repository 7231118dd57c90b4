package org.pendant.project.program.script;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.StepCode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TreeNames;

/** Tree survey: what the nodes of a tree use that are not suppressed. */
final class TreeSurvey {
  private static final Pattern WORD = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private final Set<String> waypoints = new LinkedHashSet<>();
  private final Set<String> variables = new LinkedHashSet<>();
  private final Set<String> timers = new LinkedHashSet<>();
  private final Set<String> words = new LinkedHashSet<>();
  private final Map<String, ProgramNode> subPrograms = new HashMap<>();
  private final List<ProgramNode> unnamedLoops = new ArrayList<>();
  private boolean directs;

  TreeSurvey(ProgramTree tree) {
    tree.sections().forEach(this::visit);
  }

  private void visit(ProgramNode node) {
    if (node.suppressed()) {
      return;
    }
    Step step = node.step();
    waypoints.addAll(TreeNames.waypoints(step));
    variables.addAll(TreeNames.variables(step));
    StepCode.of(step).forEach(this::read);
    switch (step) {
      case ActionStep.Timer timer -> timers.add(timer.name());
      case Section.SubProgram sub -> subPrograms.putIfAbsent(sub.name(), node);
      case MotionStep.Direction _ -> directs = true;
      case FlowStep.Loop loop when loop.rule() instanceof LoopRule.Times times ->
          unnamedLoops.addAll(times.variable().isBlank() ? List.of(node) : List.of());
      case MotionStep _, Section _, ActionStep _, FlowStep _, TemplateStep _, ForeignStep _ -> {}
    }
    node.children().forEach(this::visit);
  }

  private void read(String text) {
    addWords(text, words);
  }

  private static void addWords(String text, Set<String> words) {
    for (Matcher word = WORD.matcher(text); word.find(); ) {
      words.add(word.group());
    }
  }

  /** Every word in what a driver has sent. */
  static Set<String> words(ControlScript control) {
    Set<String> words = new LinkedHashSet<>();
    control.header().forEach(each -> addWords(each.text(), words));
    control.loop().forEach(each -> addWords(each.text(), words));
    return words;
  }

  /** Names of waypoints that nodes refer to. */
  Set<String> waypoints() {
    return waypoints;
  }

  /** Variables that nodes assign, as people call them. */
  Set<String> variables() {
    return variables;
  }

  /** Variables of stop watches. */
  Set<String> timers() {
    return timers;
  }

  /** Loops that count their turns in a variable that has no name. */
  List<ProgramNode> unnamedLoops() {
    return unnamedLoops;
  }

  /** Every word in expressions and script code. */
  Set<String> words() {
    return words;
  }

  /** The sub programs by name; of several with one name the first. */
  Map<String, ProgramNode> subPrograms() {
    return subPrograms;
  }

  /** Whether calls of a name mean that very section. */
  boolean isCalled(String name, ProgramNode section) {
    ProgramNode found = subPrograms.get(name);
    return found != null && found.key() == section.key();
  }

  /** Whether there are directions. */
  boolean directs() {
    return directs;
  }
}
