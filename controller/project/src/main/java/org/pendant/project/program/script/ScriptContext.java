package org.pendant.project.program.script;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.WaypointPosition;

/** Script context: what all writers of one script share. */
final class ScriptContext {
  private final ProgramTree tree;
  private final Installation installation;
  private final Optional<ControlScript> control;
  private final TreeSurvey survey;
  private final ScriptLines lines;
  private final ScriptNames names = new ScriptNames();
  private final Map<String, String> counting = new HashMap<>();
  private final Map<Long, String> loops = new HashMap<>();
  private final String program;

  /**
   * Gives everything its name: first to what people name themselves, then to what the script needs
   * besides.
   *
   * @param tree made of nodes of {@code whole}, whose numbers and names they keep
   * @param control what External Control nodes do
   */
  ScriptContext(
      String programName,
      ProgramTree tree,
      ProgramTree whole,
      Installation installation,
      Optional<ControlScript> control) {
    this.tree = tree;
    this.installation = installation;
    this.control = control;
    survey = new TreeSurvey(whole);
    lines = new ScriptLines(whole);
    installation.variables().stream().map(InstallationVariable::name).forEach(names::variable);
    installation.features().stream().map(Feature::name).forEach(names::variable);
    survey.variables().forEach(names::variable);
    Stream.concat(tree.waypoints().keySet().stream(), survey.waypoints().stream())
        .forEach(names::pose);
    survey.subPrograms().keySet().forEach(names::function);
    if (survey.directs()) {
      var _ = pointTowards();
    }
    for (ProgramNode loop : survey.unnamedLoops()) {
      counter(loop);
    }
    survey.timers().forEach(this::counting);
    names.reserve(survey.words());
    program = names.unique(programName, "program");
    control.ifPresent(each -> names.reserve(TreeSurvey.words(each)));
  }

  ProgramTree tree() {
    return tree;
  }

  Installation installation() {
    return installation;
  }

  /** What External Control nodes do; empty while no driver has been asked. */
  Optional<ControlScript> control() {
    return control;
  }

  TreeSurvey survey() {
    return survey;
  }

  ScriptLines lines() {
    return lines;
  }

  ScriptNames names() {
    return names;
  }

  /** A place that was taught. */
  Optional<WaypointPosition> taught(String waypoint) {
    return Optional.ofNullable(tree.waypoints().get(waypoint));
  }

  /** Whether a place of that name was taught. */
  boolean isTaught(String waypoint) {
    return tree.waypoints().containsKey(waypoint);
  }

  /** The variable that says whether a stop watch runs. */
  String counting(String timer) {
    return counting.computeIfAbsent(
        timer, name -> names.unique(names.variable(name) + "_is_counting", "is_counting"));
  }

  /** The variable in which a loop counts that has no name. */
  String counter(ProgramNode loop) {
    return loops.computeIfAbsent(loop.key(), _ -> names.numbered("Loop"));
  }

  /** The function that says where a direction leads; robots have it under this name as well. */
  String pointTowards() {
    return names.function("calculate_point_to_move_towards");
  }

  /** The function of the program. */
  String program() {
    return program;
  }
}
