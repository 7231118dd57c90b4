package org.pendant.desktop.program;

import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.OptionalDouble;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Trees for tests. */
final class Trees {
  /** The key of the main program in {@link #of}. */
  static final long MAIN = 1;

  private Trees() {}

  /** A program with these nodes below its main program; keys count on from 2. */
  static ProgramTree of(ProgramNode... nodes) {
    return ProgramTree.empty().insert(MAIN, 0, List.of(nodes));
  }

  static ProgramNode comment(String text) {
    return node(new ActionStep.Comment(text));
  }

  static ProgramNode folder(String name, ProgramNode... children) {
    return node(new ActionStep.Folder(name), children);
  }

  static ProgramNode move(ProgramNode... children) {
    return node(
        new MotionStep.Move(MoveKind.JOINT, 1, 1, new ToolChoice.Active(), "Base", false),
        children);
  }

  static ProgramNode waypoint(String name) {
    return node(
        new MotionStep.Waypoint(
            new WaypointTarget.Fixed(name), new Timing.AsMove(), OptionalDouble.empty()));
  }

  /** A place at x, m. */
  static WaypointPosition place(double x) {
    return new WaypointPosition(
        new Pose(x, 0, 0.5, 0, 0, 0), "Base", Joints.of(0, -1, 1, 0, 0, 0), Pose.ZERO);
  }

  /** The labels of all nodes but the main program, each with as many dots as it is deep. */
  static String shown(ProgramTree tree) {
    StringBuilder text = new StringBuilder();
    tree.sections().forEach(each -> show(each.children(), "", text));
    return text.toString().strip();
  }

  private static void show(List<ProgramNode> nodes, String indent, StringBuilder text) {
    for (ProgramNode each : nodes) {
      text.append(indent).append(label(each)).append(' ');
      show(each.children(), indent + ".", text);
    }
  }

  private static String label(ProgramNode node) {
    String name = Renames.nameOf(node.step()).orElseGet(() -> StepNames.label(node));
    return (node.suppressed() ? "-" : "") + name;
  }
}
