package org.pendant.project.program.script;

import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Diagnostic;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.script.vm.LoadResult;

/** Trees and nodes for tests, in few words. */
final class TestTrees {
  /** Where the arm of a test stands first. */
  static final Joints START = Joints.of(0, -1.5, -1.6, -1.6, 1.5, 0);

  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final ForwardKinematics KINEMATICS = new ForwardKinematics(ARM);

  private TestTrees() {}

  /**
   * What a compiler says of a script, but for warnings of what the nodes themselves lack: a loop
   * gets no wait, and the end of a branch is told also where nothing leads there. Nor is {@code
   * tool_pose} told, which robots still write.
   */
  static List<Diagnostic> unexpected(LoadResult result) {
    return result.diagnostics().stream()
        .filter(each -> !Set.of("endless-loop", "unreachable", "deprecated").contains(each.code()))
        .toList();
  }

  static ProgramTree tree(ProgramNode... sections) {
    return new ProgramTree("", Map.of(), List.of(), 1)
        .insert(ProgramTree.ROOT, 0, List.of(sections));
  }

  static ProgramNode once(ProgramNode... children) {
    return node(new Section.MainProgram(false), children);
  }

  static ProgramNode forever(ProgramNode... children) {
    return node(new Section.MainProgram(true), children);
  }

  /** A main program that runs once. */
  static ProgramTree program(ProgramNode... children) {
    return tree(once(children));
  }

  /** With a place that is so far from the start in each joint, rad, taught with the bare flange. */
  static ProgramTree taught(ProgramTree tree, String name, double... offsetsRad) {
    return tree.withWaypoint(name, position(offsetsRad));
  }

  static WaypointPosition position(double... offsetsRad) {
    double[] joints = START.toArray();
    for (int i = 0; i < offsetsRad.length; i++) {
      joints[i] += offsetsRad[i];
    }
    Joints taught = Joints.of(joints);
    return new WaypointPosition(
        KINEMATICS.flangePose(taught), WaypointPosition.BASE, taught, Pose.ZERO);
  }

  /** Three places {@code A}, {@code B} and {@code C} near the start. */
  static ProgramTree abc(ProgramTree tree) {
    return taught(taught(taught(tree, "A", 0.2), "B", 0.2, 0.2), "C", -0.2, 0.1, 0.1);
  }

  /** What the children of a main program generate that runs once, without indentation. */
  static String body(ProgramNode... children) {
    return body(Installation.NONE, children);
  }

  /** As {@link #body(ProgramNode...)}, with an installation. */
  static String body(Installation installation, ProgramNode... children) {
    String text = ScriptGenerator.generate("test", abc(program(children)), installation).text();
    String label = "  $ 1 \"Robot Program\"\n";
    return text.substring(text.indexOf(label) + label.length(), text.length() - "end\n".length())
        .indent(-2);
  }

  static ProgramNode moveJ(ProgramNode... children) {
    return move(MoveKind.JOINT, children);
  }

  static ProgramNode moveL(ProgramNode... children) {
    return move(MoveKind.LINEAR, children);
  }

  static ProgramNode move(MoveKind kind, ProgramNode... children) {
    return move(kind, new ToolChoice.Active(), WaypointPosition.BASE, children);
  }

  static ProgramNode move(MoveKind kind, ToolChoice tool, String feature, ProgramNode... children) {
    return node(new MotionStep.Move(kind, 0.5, 1.2, tool, feature, false), children);
  }

  static ProgramNode waypoint(String name) {
    return waypoint(new WaypointTarget.Fixed(name));
  }

  static ProgramNode blended(String name, double radiusM) {
    return node(
        new MotionStep.Waypoint(
            new WaypointTarget.Fixed(name), new Timing.AsMove(), OptionalDouble.of(radiusM)));
  }

  static ProgramNode waypoint(WaypointTarget target) {
    return waypoint(target, new Timing.AsMove());
  }

  static ProgramNode waypoint(WaypointTarget target, Timing timing) {
    return node(new MotionStep.Waypoint(target, timing, OptionalDouble.empty()));
  }

  static ProgramNode script(String... code) {
    return node(new ActionStep.ScriptLine(String.join("\n", code)));
  }

  static ProgramNode say(String text) {
    return script("textmsg(\"" + text + "\")");
  }

  static ProgramNode assign(String variable, String expression) {
    return node(new ActionStep.Assignment(variable, expression));
  }

  static ProgramNode set(Setting setting) {
    return node(new ActionStep.SetAction(setting));
  }

  static ProgramNode output(int number, boolean level) {
    return set(new Setting.Digital("digital_out[" + number + "]", level));
  }

  static ProgramNode waitFor(WaitFor what) {
    return node(new ActionStep.Wait(what));
  }

  static ProgramNode sleep(double timeS) {
    return waitFor(new WaitFor.Time(timeS));
  }

  static ProgramNode suppressed(ProgramNode node) {
    return node.withSuppressed(true);
  }
}
