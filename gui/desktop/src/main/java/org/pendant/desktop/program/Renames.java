package org.pendant.desktop.program;

import java.util.Optional;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.PlaceNames;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.SeekChange;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.WaypointTarget;

/** Renames: what nodes are called, and calling them otherwise wherever they are named. */
final class Renames {
  private Renames() {}

  /** The text that can be changed in the tree itself; empty for nodes that have none. */
  static Optional<String> nameOf(Step step) {
    return switch (step) {
      case MotionStep.Waypoint waypoint ->
          switch (waypoint.target()) {
            case WaypointTarget.Fixed fixed -> Optional.of(fixed.name());
            case WaypointTarget.Relative relative -> Optional.of(relative.name());
            case WaypointTarget.Variable variable -> Optional.of(variable.expression());
          };
      case ActionStep.Folder folder -> Optional.of(folder.name());
      case ActionStep.Comment comment -> Optional.of(comment.text());
      case ActionStep.ScriptLine line -> Optional.of(line.code());
      case Section.ThreadSection thread -> Optional.of(thread.name());
      case Section.SubProgram sub -> Optional.of(sub.name());
      case TemplateStep.Palletizing pallet -> Optional.of(pallet.name());
      case TemplateStep.Seek seek -> Optional.of(seek.name());
      case TemplateStep.PatternPoint point -> Optional.of(point.waypoint());
      case Section other -> Optional.empty();
      case MotionStep other -> Optional.empty();
      case ActionStep other -> Optional.empty();
      case FlowStep other -> Optional.empty();
      case TemplateStep other -> Optional.empty();
      case ForeignStep other -> Optional.empty();
    };
  }

  /** The tree with a node called otherwise, and everything that names it. */
  static ProgramTree rename(ProgramTree tree, long key, String name) {
    Optional<ProgramNode> node = tree.find(key);
    if (node.isEmpty() || nameOf(node.get().step()).filter(name::equals).isPresent()) {
      return tree;
    }
    Step step = node.get().step();
    return switch (step) {
      case MotionStep.Waypoint waypoint ->
          switch (waypoint.target()) {
            case WaypointTarget.Fixed fixed -> PlaceNames.renamed(tree, fixed.name(), name);
            case WaypointTarget.Relative relative ->
                tree.withStep(
                    key,
                    withTarget(
                        waypoint,
                        new WaypointTarget.Relative(name, relative.from(), relative.to())));
            case WaypointTarget.Variable variable ->
                tree.withStep(key, withTarget(waypoint, new WaypointTarget.Variable(name)));
          };
      case ActionStep.Folder folder -> tree.withStep(key, new ActionStep.Folder(name));
      case ActionStep.Comment comment -> tree.withStep(key, new ActionStep.Comment(name));
      case ActionStep.ScriptLine line -> tree.withStep(key, new ActionStep.ScriptLine(name));
      case Section.ThreadSection thread ->
          tree.withStep(key, new Section.ThreadSection(name, thread.forever()));
      case Section.SubProgram sub -> renameSubProgram(tree, key, sub, name);
      case TemplateStep.Palletizing pallet ->
          tree.withStep(
              key,
              new TemplateStep.Palletizing(
                  name, pallet.pattern(), pallet.feature(), pallet.remember()));
      case TemplateStep.Seek seek -> tree.withStep(key, new SeekChange(seek).name(name));
      case TemplateStep.PatternPoint point -> PlaceNames.renamed(tree, point.waypoint(), name);
      case Section other -> tree;
      case MotionStep other -> tree;
      case ActionStep other -> tree;
      case FlowStep other -> tree;
      case TemplateStep other -> tree;
      case ForeignStep other -> tree;
    };
  }

  private static ProgramTree renameSubProgram(
      ProgramTree tree, long key, Section.SubProgram sub, String name) {
    ProgramTree next = tree.withStep(key, new Section.SubProgram(name, sub.file()));
    for (ProgramNode each : tree.nodes()) {
      if (each.step() instanceof ActionStep.Call(String called) && called.equals(sub.name())) {
        next = next.withStep(each.key(), new ActionStep.Call(name));
      }
    }
    return next;
  }

  private static MotionStep.Waypoint withTarget(
      MotionStep.Waypoint waypoint, WaypointTarget target) {
    return new MotionStep.Waypoint(target, waypoint.timing(), waypoint.blendRadiusM());
  }
}
