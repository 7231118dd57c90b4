package org.pendant.project.program;

import java.text.Normalizer;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Tree names: the names that a program tree gives to something, also where it has not been taught
 * yet.
 */
public final class TreeNames {
  private TreeNames() {}

  /** All of them: of waypoints, variables, timers, threads, sub programs and templates. */
  public static Set<String> all(ProgramTree tree) {
    Set<String> names = new LinkedHashSet<>(tree.waypoints().keySet());
    tree.forEach(
        node -> {
          names.addAll(waypoints(node.step()));
          names.addAll(variables(node.step()));
          names.addAll(parts(node.step()));
        });
    names.remove("");
    return names;
  }

  /** The taught places that a step is about, in the order of its form; empty texts are missing. */
  public static List<String> waypoints(Step step) {
    return switch (step) {
      case MotionStep.Waypoint waypoint ->
          switch (waypoint.target()) {
            case WaypointTarget.Fixed fixed -> List.of(fixed.name());
            case WaypointTarget.Relative relative -> List.of(relative.from(), relative.to());
            case WaypointTarget.Variable variable -> List.of();
          };
      case TemplateStep.Palletizing palletizing -> corners(palletizing.pattern());
      case TemplateStep.PatternPoint point -> List.of(point.waypoint());
      case TemplateStep.Seek seek -> List.of(seek.start());
      case TemplateStep _ -> List.of();
      case MotionStep _ -> List.of();
      case Section _ -> List.of();
      case ActionStep _ -> List.of();
      case FlowStep _ -> List.of();
      case ForeignStep _ -> List.of();
    };
  }

  /** The names of the places of a pattern. */
  public static List<String> corners(Pattern pattern) {
    return switch (pattern) {
      case Pattern.Line line -> List.of(line.first(), line.last());
      case Pattern.Square square -> square.corners();
      case Pattern.Box box -> box.corners();
      case Pattern.Places places -> places.places();
    };
  }

  /** The variables that a step gives a value. */
  public static List<String> variables(Step step) {
    return switch (step) {
      case ActionStep.Assignment assignment -> List.of(assignment.variable());
      case ActionStep.OperatorInput input -> List.of(input.variable());
      case ActionStep.Timer timer -> List.of(timer.name());
      case ActionStep _ -> List.of();
      case Section.InitialValues initial ->
          initial.values().stream().map(Section.InitialValue::variable).toList();
      case Section _ -> List.of();
      case FlowStep.Loop loop ->
          loop.rule() instanceof LoopRule.Times times && !times.variable().isEmpty()
              ? List.of(times.variable())
              : List.of();
      case FlowStep _ -> List.of();
      case TemplateStep.Palletizing palletizing -> List.of(counter(palletizing.name()));
      case TemplateStep.Seek seek -> List.of(counter(seek.name()));
      case TemplateStep _ -> List.of();
      case MotionStep _ -> List.of();
      case ForeignStep _ -> List.of();
    };
  }

  /**
   * A name of the language as near to one of people as can be. Letters that the language does not
   * have are written by their number, as robots do: \u5faa as {@code u24490}.
   *
   * @param fallback when nothing of {@code wanted} can be used
   */
  public static String word(String wanted, String fallback) {
    StringBuilder plain = new StringBuilder();
    Normalizer.normalize(wanted.strip(), Normalizer.Form.NFC)
        .chars()
        .forEach(
            each -> {
              if (each < 128 || !Character.isLetterOrDigit(each)) {
                plain.append((char) each);
              } else {
                plain.append('u').append(each);
              }
            });
    String name = plain.toString().replaceAll("[^A-Za-z0-9_]+", "_");
    if (name.isEmpty() || name.chars().allMatch(c -> c == '_')) {
      return fallback;
    }
    return Character.isDigit(name.charAt(0)) ? "_" + name : name;
  }

  /** What the variables of a taught place begin with, unless those of another one do. */
  public static String place(String waypoint) {
    return word(waypoint, "Waypoint");
  }

  /** The variable in which a template of that name counts. */
  public static String counter(String template) {
    return template + "_count";
  }

  private static List<String> parts(Step step) {
    return switch (step) {
      case Section.ThreadSection thread -> List.of(thread.name());
      case Section.SubProgram sub -> List.of(sub.name());
      case TemplateStep.Palletizing palletizing -> List.of(palletizing.name());
      case TemplateStep.Seek seek -> List.of(seek.name());
      case MotionStep.Waypoint waypoint ->
          waypoint.target() instanceof WaypointTarget.Relative relative
              ? List.of(relative.name())
              : List.of();
      case Section _ -> List.of();
      case TemplateStep _ -> List.of();
      case MotionStep _ -> List.of();
      case ActionStep _ -> List.of();
      case FlowStep _ -> List.of();
      case ForeignStep _ -> List.of();
    };
  }
}
