package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
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
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.text.ProgramText;

/** Starting programs that are trees: at a node, and with the arm away from where they go first. */
@Tag("slow")
final class StartWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  /** So far away that the move there is still seen on a busy machine. */
  private static final Joints PLACE =
      Joints.of(0.6, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  private final OpenWindow window = sharedWindow.window();

  @TempDir Path folder;

  private static ProgramNode say(String text) {
    return node(new ActionStep.ScriptLine("textmsg(\"" + text + "\")"));
  }

  /** Opens a program whose main part runs once. */
  private void open(String name, ProgramNode... nodes) throws IOException {
    Pose tcp = new ForwardKinematics(ArmLibrary.load("ur5e")).flangePose(PLACE);
    ProgramTree tree =
        new ProgramTree(
                "",
                Map.of("Pick", new WaypointPosition(tcp, WaypointPosition.BASE, PLACE, Pose.ZERO)),
                List.of(),
                1)
            .insert(ProgramTree.ROOT, 0, List.of(node(new Section.MainProgram(false), nodes)));
    Path file = folder.resolve(name);
    Files.writeString(file, ProgramText.write(tree));
    window.open(file);
  }

  private static ProgramNode moveToPick() {
    return node(
        new MotionStep.Move(
            MoveKind.JOINT, 1, 1, new ToolChoice.Active(), WaypointPosition.BASE, false),
        node(
            new MotionStep.Waypoint(
                new WaypointTarget.Fixed("Pick"), new Timing.AsMove(), OptionalDouble.empty())));
  }

  @Test
  void runsFromTheSelectedNode() throws IOException {
    open("lines.pendant", say("line one"), say("line two"), say("line three"));
    window.perform("Show Program");
    window.perform("Go to the tree");
    window.awaitFocus("program-tree");
    window.press("HOME");
    window.press("DOWN");
    window.press("DOWN");
    window.press("control F5");
    window.click("rail-run");
    window.awaitWords("run-messages", "line three");
    window.awaitWords("program-state", "stopped");
    String said = window.words("run-messages");
    assertTrue(said.contains("line two"), said);
    assertFalse(said.contains("line one"), said);
  }

  @Test
  void theArmIsMovedToTheFirstWaypointBeforeTheProgramStarts() throws IOException {
    open(
        "pick.pendant",
        moveToPick(),
        say("picked"),
        node(new ActionStep.Wait(new WaitFor.Time(1))));
    window.press("F5");
    window.awaitWords("start-choice", "The arm is not at Pick");
    assertTrue(window.whole("program-stop"), "Stop can be seen");
    window.awaitFocus("start-cancel");
    window.press("ESCAPE");
    window.awaitHidden("start-choice");
    window.awaitWords("program-state", "stopped");

    window.press("F5");
    window.awaitShown("start-choice");
    window.click("start-move");
    window.awaitWords("start-choice", "The arm moves to Pick");
    window.awaitWords("run-messages", "picked");
    window.awaitHidden("start-choice");
    window.awaitWords("run-joints-base", "34.38");
    window.awaitWords("program-state", "stopped");

    // It is there now.
    window.press("F5");
    window.await(
        "it runs again", () -> window.words("run-messages").split("picked", -1).length > 2);
    window.awaitWords("program-state", "stopped");
    assertFalse(window.shows("start-choice"));
  }
}
