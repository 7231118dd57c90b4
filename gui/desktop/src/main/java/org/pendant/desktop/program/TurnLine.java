package org.pendant.desktop.program;

import java.util.List;
import java.util.stream.Stream;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.script.GeneratedScript;

/** Turn line: finds where the turns of a main program can be counted. */
final class TurnLine {
  private TurnLine() {}

  /**
   * The line of the label before a node that the main program comes to once in each turn; 0 if it
   * does not go round, or there is no such node.
   *
   * @param script of the tree, or of a run that starts in its middle
   */
  static int of(ProgramTree tree, GeneratedScript script) {
    return tree.sections().stream()
        .filter(each -> each.step() instanceof Section.MainProgram main && main.forever())
        .flatMap(main -> main.children().stream())
        .flatMap(TurnLine::once)
        .mapToInt(node -> line(node.key(), script))
        .filter(line -> line > 0)
        .findFirst()
        .orElse(0);
  }

  /** The nodes in a node, itself included, that each turn comes to, and once. */
  private static Stream<ProgramNode> once(ProgramNode node) {
    if (node.suppressed()) {
      return Stream.empty();
    }
    return switch (node.step()) {
      case MotionStep.Move _, ActionStep.Folder _ ->
          node.children().stream().flatMap(TurnLine::once);
      case MotionStep.Waypoint _ -> node.children().isEmpty() ? Stream.of(node) : Stream.empty();
      case ActionStep.Wait wait when !(wait.what() instanceof WaitFor.Time) -> Stream.empty();
      case ActionStep.Comment _, ActionStep.ScriptFile _, ActionStep.Halt _ -> Stream.empty();
      case ActionStep.ScriptLine line ->
          line.code().strip().matches("[a-zA-Z_][a-zA-Z0-9_]*\\s*[(=].*")
              ? Stream.of(node)
              : Stream.empty();
      case ActionStep _ -> Stream.of(node);
      case FlowStep.If each when !each.continuously() -> Stream.of(node);
      default -> Stream.empty();
    };
  }

  /** The label before the last of a node's places: a loop comes behind a first turn of its own. */
  private static int line(long key, GeneratedScript script) {
    int first =
        script.places().stream()
            .filter(each -> each.key() == key)
            .mapToInt(GeneratedScript.NodeLines::first)
            .max()
            .orElse(0);
    List<String> lines = script.text().lines().toList();
    return first > 1 && lines.get(first - 2).strip().startsWith("$ ") ? first - 1 : 0;
  }
}
