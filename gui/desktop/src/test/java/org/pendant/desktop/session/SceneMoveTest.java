package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;

final class SceneMoveTest {
  private static final String BLOCK =
      "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 30 20 20\n"
          + "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

  @TempDir Path folder;
  private Path cell;
  private Scene scene;

  @BeforeEach
  void writeScene() throws IOException {
    cell = Files.createDirectories(folder.resolve("work/cell"));
    Files.createDirectory(cell.resolve("parts"));
    Files.writeString(cell.resolve("parts/a.obj"), BLOCK);
    Path file =
        Files.writeString(
            cell.resolve("a.scene.json"),
            "{\"objects\": [{\"type\": \"mesh\", \"name\": \"a\", \"pose\": [0, 0, 0, 0, 0, 0],"
                + " \"mesh\": \"parts/a.obj\", \"unit\": \"mm\", \"mass\": 2}]}");
    scene = SceneFile.read(file).scene();
  }

  private static String file(Scene of) {
    return ((SceneObject.Mesh) of.objects().getFirst()).part().file();
  }

  @Test
  void aFolderAboveNamesTheSameFiles() {
    SceneMove move = new SceneMove(cell, folder.resolve("work"));

    assertEquals("cell/parts/a.obj", file(move.renamed(scene)));
    assertEquals(2, move.renamed(scene).objects().getFirst().massKg());
    assertEquals(List.of(), move.toCopy(scene, List.of()));
  }

  @Test
  void theFolderOfTheMeshesNamesThemShorter() {
    SceneMove move = new SceneMove(cell, cell.resolve("parts"));

    assertEquals("a.obj", file(move.renamed(scene)));
    assertEquals(List.of(), move.toCopy(scene, List.of()));
  }

  @Test
  void elsewhereTheyAreCopiedUnderTheSameNames() throws IOException {
    Path other = folder.resolve("other");
    SceneMove move = new SceneMove(cell, other);

    assertEquals(scene, move.renamed(scene));
    assertEquals(List.of("parts/a.obj"), move.toCopy(scene, List.of()));
    move.copy(move.toCopy(scene, List.of()));
    assertEquals(BLOCK, Files.readString(other.resolve("parts/a.obj")));
    move.copy(move.toCopy(scene, List.of()));
  }

  @Test
  void whatIsOnAFlangeMovesLikeObjects() {
    Scene mounted = scene.withToolBodies(scene.objects()).withObjects(List.of());
    SceneMove above = new SceneMove(cell, folder.resolve("work"));
    SceneObject.Mesh body = (SceneObject.Mesh) above.renamed(mounted).toolBodies().getFirst();
    assertEquals("cell/parts/a.obj", body.part().file());
    SceneMove elsewhere = new SceneMove(cell, folder.resolve("other"));
    assertEquals(List.of("parts/a.obj"), elsewhere.toCopy(mounted, List.of()));
  }

  @Test
  void theToolsOfArmsKeepTheNamesOfTheirMeshesSoTheyAreCopied() {
    SceneMove above = new SceneMove(cell, folder.resolve("work"));
    assertEquals(List.of("parts/a.obj"), above.toCopy(Scene.EMPTY, scene.meshes()));
    SceneMove same = new SceneMove(cell, cell);
    assertEquals(List.of(), same.toCopy(Scene.EMPTY, scene.meshes()));
  }

  @Test
  void nothingIsReplaced() throws IOException {
    Path other = Files.createDirectories(folder.resolve("other/parts"));
    Files.writeString(other.resolve("a.obj"), "mine");
    SceneMove move = new SceneMove(cell, folder.resolve("other"));

    String why =
        assertThrows(IOException.class, () -> move.copy(move.toCopy(scene, List.of())))
            .getMessage();
    assertTrue(why.endsWith("a.obj is there already, and is another file"), why);
    assertEquals("mine", Files.readString(other.resolve("a.obj")));
  }

  @Test
  void inTheSameFolderNothingHappens() {
    SceneMove move = new SceneMove(cell, cell.resolve("../cell"));

    assertEquals(scene, move.renamed(scene));
    assertTrue(move.toCopy(scene, List.of()).isEmpty());
    assertFalse(scene.objects().isEmpty());
  }
}
