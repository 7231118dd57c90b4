package org.pendant.desktop.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.pose.Pose;
import org.pendant.project.installation.text.InstallationText;

final class EditingTest {
  private static final NamedTool GRIPPER = new NamedTool("Gripper", Pose.ZERO);

  private final ActiveInstallation active = new ActiveInstallation();
  private final Editing editing = new Editing(active, () -> ArmLibrary.load("ur5e"));

  @Test
  void changesAreUndoneAndMadeAgain() {
    editing.take(parts -> parts.tools = List.of(GRIPPER));
    editing.take(parts -> parts.activeTool = "Gripper");
    editing.undo();
    assertEquals("", editing.now().activeTool());
    assertEquals(List.of(GRIPPER), editing.now().tools());
    editing.undo();
    assertEquals(Installation.NONE, editing.now());
    assertFalse(editing.canUndo());
    editing.redo();
    editing.redo();
    assertEquals("Gripper", editing.now().activeTool());
    assertFalse(editing.canRedo());
  }

  @Test
  void aNewChangeEndsWhatCouldBeMadeAgain() {
    editing.take(parts -> parts.tools = List.of(GRIPPER));
    editing.undo();
    editing.take(parts -> parts.robot = "ur5e");
    assertFalse(editing.canRedo());
  }

  @Test
  void refusesWhatWouldBecomeWrong() {
    editing.take(parts -> parts.tools = List.of(GRIPPER));
    assertEquals(
        "Gripper is the name of another one too",
        editing.refusal(parts -> parts.tools = List.of(GRIPPER, GRIPPER)));
    assertEquals("", editing.refusal(parts -> parts.activeTool = "Gripper"));
  }

  @Test
  void whatIsWrongAlreadyKeepsNobodyFromChangingSomethingElse() {
    active.set(Installation.NONE.with(parts -> parts.robot = "ur10e"));
    assertEquals("", editing.refusal(parts -> parts.tools = List.of(GRIPPER)));
  }

  @Test
  void anotherFileHasNothingToUndo() {
    editing.take(parts -> parts.tools = List.of(GRIPPER));
    active.open(ProgramDocument.untitled("cell.pinst", InstallationText.write(Installation.NONE)));
    assertFalse(editing.canUndo());
    assertFalse(editing.canRedo());
  }

  @Test
  void theActiveTcpFollowsItsName() {
    Listed<NamedTool> tools =
        new Listed<>(
            editing,
            Installation::tools,
            (parts, all) -> parts.tools = all,
            (parts, before, after) -> parts.activeTool = after.map(NamedTool::name).orElse(""));
    editing.take(
        parts -> {
          parts.tools = List.of(GRIPPER);
          parts.activeTool = "Gripper";
        });
    List<NamedTool> renamed = List.of(new NamedTool("Claw", Pose.ZERO));
    assertEquals("", tools.refusal(renamed));
    tools.take(renamed, java.util.Optional.of(GRIPPER), java.util.Optional.of(renamed.getFirst()));
    assertEquals("Claw", editing.now().activeTool());
    assertTrue(editing.canUndo());
  }
}
