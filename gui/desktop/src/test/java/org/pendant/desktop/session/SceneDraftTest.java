package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.SceneWriter;
import org.pendant.controller.world.Vector3;

final class SceneDraftTest {
  /** A pyramid on a triangle. */
  private static final String TIP =
      """
      v 0 0 0
      v 50 0 0
      v 0 50 0
      v 10 10 80
      f 1 3 2
      f 1 2 4
      f 2 3 4
      f 3 1 4
      """;

  @TempDir Path folder;

  private final SceneDraft draft = new SceneDraft();

  private static Scene ball(double radiusM) {
    return new Scene(
        List.of(new SceneObject.Sphere("ball", new Vector3(0.4, 0, 0), radiusM, Material.DEFAULT)),
        Optional.empty(),
        List.of());
  }

  @Test
  void aChangeIsWrittenAndUndone() {
    draft.set(ball(0.1));
    draft.set(ball(0.2));
    assertEquals(SceneWriter.write(ball(0.2)), draft.document().text());
    assertTrue(draft.document().modified());
    draft.undo();
    assertEquals(ball(0.1), draft.scene());
    draft.undo();
    assertFalse(draft.document().modified(), "back where it began");
    assertFalse(draft.canUndo());
    draft.redo();
    draft.redo();
    assertEquals(ball(0.2), draft.scene());
    assertFalse(draft.canRedo());
  }

  @Test
  void whoUndoesEverythingHasTheFileAsItIsWrittenOnDisk() throws Exception {
    String odd = "{ \"objects\" :[] }";
    draft.open(
        SceneFile.of("odd.scene.json", odd)
            .at(
                "odd.scene.json",
                Optional.of(SavedProgram.create(Path.of("odd.scene.json"), odd))));
    draft.set(ball(0.1));
    draft.undo();
    assertEquals(odd, draft.document().text());
    assertFalse(draft.document().modified());
  }

  @Test
  void whatIsNoPartOfTheSceneStaysInTheFile() throws Exception {
    String rules =
        """
        [
            {"every": 5, "set": "digital_in[0]", "for": 0.1}
          ]\
        """;
    draft.open(SceneFile.of("rules.scene.json", "{\"objects\": [], \"rules\": " + rules + "}"));
    draft.set(ball(0.1));
    assertTrue(draft.document().text().contains(",\n  \"rules\": " + rules + "\n}\n"));
    SceneFile again = SceneFile.of("again", draft.document().text());
    assertEquals(ball(0.1), again.scene());
    assertEquals(1, again.equipment().rules().size());
  }

  @Test
  void whatWasNotSavedIsTheSameAfterACrash() throws Exception {
    draft.restore(
        ProgramDocument.untitled(SceneDraft.UNTITLED, "{}\n"),
        Scene.EMPTY,
        SceneFile.of("left", SceneWriter.write(ball(0.1))));
    assertEquals(ball(0.1), draft.scene());
    assertTrue(draft.document().modified());
    draft.undo();
    assertEquals(Scene.EMPTY, draft.scene());
  }

  @Test
  void anotherSceneCannotBeUndone() {
    draft.set(ball(0.1));
    draft.open(SceneFile.NONE);
    assertEquals(Scene.EMPTY, draft.scene());
    assertFalse(draft.canUndo());
    assertFalse(draft.document().modified());
  }

  @Test
  void everyChangeIsTold() {
    int[] told = {0};
    draft.addListener(() -> told[0]++);
    draft.set(ball(0.1));
    int afterOne = told[0];
    assertTrue(afterOne > 0);
    draft.set(ball(0.1));
    assertEquals(afterOne, told[0], "the same again is no change");
  }

  @Test
  void theMeshesOfToolsAreThereWhileOtherThingsChange() throws Exception {
    Files.writeString(folder.resolve("tip.obj"), TIP);
    String tool =
        "\"tool\": [{\"type\": \"mesh\", \"name\": \"tip\", \"pose\": [0, 0, 0.1, 0, 0, 0],"
            + " \"mesh\": \"tip.obj\", \"unit\": \"mm\"}]";
    Path file =
        Files.writeString(
            folder.resolve("tools.scene.json"),
            "{%1$s, \"arms\": [{\"name\": \"left\"}, {\"name\": \"right\", %1$s}]}"
                .formatted(tool));
    draft.open(SceneFile.read(file));
    draft.set(draft.scene().withObjects(ball(0.1).objects()));
    assertEquals(List.of("left", "right"), draft.controllers());
    SceneFile again = SceneFile.of("again", draft.document().text(), draft.meshes());
    assertEquals(1, again.scene().toolBodies().size());
    assertEquals(1, again.plan().meshesOfArms().size());
  }

  @Test
  void theScriptOfACellStaysInTheFile() throws Exception {
    draft.open(SceneFile.of("two.scene.json", SharedCell.SCENE));
    assertEquals(List.of("left", "right", "cell"), draft.controllers());
    draft.set(ball(0.1));
    SceneFile again = SceneFile.of("again", draft.document().text());
    assertEquals("cell.script", again.plan().layout().script().orElseThrow().name());
  }
}
