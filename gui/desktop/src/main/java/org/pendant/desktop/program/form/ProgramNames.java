package org.pendant.desktop.program.form;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.Identifiers;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TreeNames;

/** Program names: what a program and its installation have given names to. */
final class ProgramNames {
  private static final Pattern ASSIGNED =
      Pattern.compile("(?:^|[\\s;])(?:global\\s+|local\\s+)?([A-Za-z_]\\w*)\\s*=(?!=)");
  private static final Pattern DEFINED =
      Pattern.compile("\\bdef\\s+([A-Za-z_]\\w*\\s*\\([\\w\\s,]*\\))");

  private ProgramNames() {}

  /** The variables that nodes give values to, in the order of the program. */
  static List<String> ownVariables(ProgramTree tree) {
    Set<String> names = new LinkedHashSet<>();
    tree.forEach(node -> assigned(node.step()).filter(Identifiers::wellFormed).forEach(names::add));
    return List.copyOf(names);
  }

  /** The variables of the installation, and its features that are variables. */
  static List<String> sharedVariables(Installation installation) {
    return Stream.of(
            installation.variables().stream().map(InstallationVariable::name),
            installation.features().stream().map(Feature::name),
            installation.modbus().stream().map(ModbusSetup::name))
        .flatMap(each -> each)
        .filter(Identifiers::wellFormed)
        .distinct()
        .toList();
  }

  /** Everything that an expression may name besides functions. */
  static List<String> variables(ProgramTree tree, Installation installation) {
    Stream<String> places =
        WaypointNames.of(tree).stream()
            .filter(Identifiers::wellFormed)
            .flatMap(name -> Stream.of(name + "_p", name + "_q"));
    return Stream.of(ownVariables(tree).stream(), sharedVariables(installation).stream(), places)
        .flatMap(each -> each)
        .distinct()
        .toList();
  }

  /** The heads of functions that the program itself defines, such as {@code f(a, b)}. */
  static List<String> functions(ProgramTree tree) {
    Set<String> heads = new LinkedHashSet<>();
    subPrograms(tree).stream()
        .filter(Identifiers::wellFormed)
        .forEach(each -> heads.add(each + "()"));
    tree.forEach(
        node ->
            found(DEFINED, code(node.step()))
                .map(head -> head.replaceAll("\\s+", ""))
                .forEach(heads::add));
    return List.copyOf(heads);
  }

  /** The names of sub programs. */
  static List<String> subPrograms(ProgramTree tree) {
    return tree.sections().stream()
        .map(node -> node.step() instanceof Section.SubProgram sub ? sub.name() : "")
        .filter(name -> !name.isEmpty())
        .distinct()
        .toList();
  }

  /** The names of stop watches. */
  static List<String> timers(ProgramTree tree) {
    return tree.nodes().stream()
        .map(node -> node.step() instanceof ActionStep.Timer timer ? timer.name() : "")
        .filter(name -> !name.isEmpty())
        .distinct()
        .toList();
  }

  private static Stream<String> assigned(Step step) {
    return Stream.concat(TreeNames.variables(step).stream(), found(ASSIGNED, code(step)));
  }

  private static String code(Step step) {
    return switch (step) {
      case ActionStep.ScriptLine each -> each.code();
      case ActionStep.ScriptFile each -> String.join("\n", each.lines());
      case Section _, MotionStep _, ActionStep _, FlowStep _, TemplateStep _, ForeignStep _ -> "";
    };
  }

  private static Stream<String> found(Pattern pattern, String text) {
    List<String> names = new ArrayList<>();
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      names.add(matcher.group(1));
    }
    return names.stream();
  }
}
