package org.pendant.project.program;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.LexemeReader;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;

/** Renaming of taught places, wherever nodes or the code in them name them. */
public final class PlaceNames {
  /** Endings of the variables that a place has in the script: its pose, its joint positions. */
  private static final List<String> VARIABLES = List.of("_p", "_q");

  private PlaceNames() {}

  /**
   * The tree with one place called otherwise; if there is a place of the new name already, the
   * nodes go to that one. Copies of script files stay as their files are.
   */
  public static ProgramTree renamed(ProgramTree tree, String from, String to) {
    if (from.isEmpty() || from.equals(to)) {
      return tree;
    }
    Map<String, WaypointPosition> places = new LinkedHashMap<>();
    tree.waypoints()
        .forEach(
            (name, position) -> {
              if (!name.equals(from)) {
                places.put(name, position);
              } else if (!tree.waypoints().containsKey(to)) {
                places.put(to, position);
              }
            });
    UnaryOperator<String> name = each -> each.equals(from) ? to : each;
    UnaryOperator<String> code = code(words(tree, name));
    List<ProgramNode> sections =
        tree.sections().stream().map(each -> renamed(each, name, code)).toList();
    return new ProgramTree(tree.installation(), places, sections, tree.nextKey());
  }

  /**
   * A node and all below it, with other names of places.
   *
   * @param names the new name of each place that gets one
   */
  public static ProgramNode renamed(ProgramNode node, Map<String, String> names) {
    Map<String, String> words = new HashMap<>();
    names.forEach((from, to) -> put(words, TreeNames.place(from), TreeNames.place(to)));
    return renamed(node, each -> names.getOrDefault(each, each), code(words));
  }

  private static ProgramNode renamed(
      ProgramNode node, UnaryOperator<String> name, UnaryOperator<String> code) {
    List<ProgramNode> below =
        node.children().stream().map(each -> renamed(each, name, code)).toList();
    Step step = renamed(node.step(), name);
    boolean ofFile = step instanceof ActionStep.ScriptFile(String file, _) && !file.isBlank();
    ProgramNode result =
        new ProgramNode(
            node.key(), ofFile ? step : StepCode.changed(step, code), node.suppressed(), below);
    return result.equals(node) ? node : result;
  }

  // --- the variables of places

  /** Which words of the script become others when places are called otherwise. */
  private static Map<String, String> words(ProgramTree tree, UnaryOperator<String> name) {
    Set<String> before = new LinkedHashSet<>(tree.waypoints().keySet());
    Set<String> taken = new HashSet<>();
    tree.forEach(
        node -> {
          before.addAll(TreeNames.waypoints(node.step()));
          taken.addAll(TreeNames.variables(node.step()));
        });
    Set<String> after = new LinkedHashSet<>(before.stream().map(name).toList());
    Map<String, String> old = stems(before, taken);
    Map<String, String> now = stems(after, taken);
    Map<String, String> words = new HashMap<>();
    before.forEach(each -> put(words, old.get(each), now.get(name.apply(each))));
    return words;
  }

  private static void put(Map<String, String> words, String from, String to) {
    if (!from.equals(to)) {
      VARIABLES.forEach(ending -> words.put(from + ending, to + ending));
    }
  }

  /** What the variables of each place begin with, as the script names them: no two are alike. */
  private static Map<String, String> stems(Set<String> places, Set<String> variables) {
    Set<String> taken = new HashSet<>(variables);
    Map<String, String> stems = new HashMap<>();
    for (String place : places) {
      String word = TreeNames.place(place);
      String stem = word;
      for (int i = 2; VARIABLES.stream().map(stem::concat).anyMatch(taken::contains); i++) {
        stem = word + "_" + i;
      }
      VARIABLES.stream().map(stem::concat).forEach(taken::add);
      stems.put(place, stem);
    }
    return stems;
  }

  private static UnaryOperator<String> code(Map<String, String> words) {
    return text -> words.keySet().stream().anyMatch(text::contains) ? code(text, words) : text;
  }

  /** URScript with other words in place of some; strings, comments and members stay. */
  private static String code(String text, Map<String, String> words) {
    String bytes = ByteText.asBytes(text);
    StringBuilder result = new StringBuilder();
    int copied = 0;
    boolean member = false;
    for (Lexeme each : LexemeReader.lexemes(Source.of("code", text))) {
      String to =
          each.kind() == Lexeme.Kind.NAME && !member
              ? words.get(bytes.substring(each.start(), each.end()))
              : null;
      if (to != null) {
        result.append(bytes, copied, each.start()).append(to);
        copied = each.end();
      }
      member = each.kind() == Lexeme.Kind.DOT;
    }
    return ByteText.decoded(result.append(bytes.substring(copied)).toString());
  }

  // --- the names in nodes

  private static Step renamed(Step step, UnaryOperator<String> name) {
    return switch (step) {
      case MotionStep.Waypoint(WaypointTarget target, var timing, var blendRadiusM) ->
          new MotionStep.Waypoint(renamed(target, name), timing, blendRadiusM);
      case TemplateStep.Palletizing(var own, Pattern pattern, var feature, var remember) ->
          new TemplateStep.Palletizing(own, renamed(pattern, name), feature, remember);
      case TemplateStep.PatternPoint point ->
          new TemplateStep.PatternPoint(
              point.role(),
              name.apply(point.waypoint()),
              point.kind(),
              point.speed(),
              point.acceleration(),
              point.blendRadiusM());
      case TemplateStep.Seek seek -> new SeekChange(seek).start(name.apply(seek.start()));
      case MotionStep _, TemplateStep _, Section _, ActionStep _, FlowStep _, ForeignStep _ -> step;
    };
  }

  private static WaypointTarget renamed(WaypointTarget target, UnaryOperator<String> name) {
    return switch (target) {
      case WaypointTarget.Fixed(String own) -> new WaypointTarget.Fixed(name.apply(own));
      case WaypointTarget.Relative(String own, String from, String to) ->
          new WaypointTarget.Relative(own, name.apply(from), name.apply(to));
      case WaypointTarget.Variable _ -> target;
    };
  }

  private static Pattern renamed(Pattern pattern, UnaryOperator<String> name) {
    return switch (pattern) {
      case Pattern.Line(String first, String last, int count) ->
          new Pattern.Line(name.apply(first), name.apply(last), count);
      case Pattern.Square(List<String> corners, int columns, int rows) ->
          new Pattern.Square(corners.stream().map(name).toList(), columns, rows);
      case Pattern.Box(List<String> corners, int columns, int rows, int layers) ->
          new Pattern.Box(corners.stream().map(name).toList(), columns, rows, layers);
      case Pattern.Places(List<String> places) ->
          new Pattern.Places(places.stream().map(name).toList());
    };
  }
}
