package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

/** Scenes on disk, and which of them belongs to which installation. */
final class SceneFileTest {
  private static final String TABLE =
      """
      {"objects": [{"type": "plane", "name": "table", "point": [0, 0, 0], "normal": [0, 0, 1]}]}
      """;

  @TempDir Path folder;

  /** Settings in memory. */
  @Test
  void aSceneIsReadFromItsFile() throws IOException {
    Path file = Files.writeString(folder.resolve("cell.scene.json"), TABLE);

    SceneFile scene = SceneFile.read(file);

    assertEquals(Optional.of(file), scene.path());
    assertEquals("cell.scene.json, 1 object", scene.words());
    assertEquals("table", scene.scene().objects().getFirst().name());
  }

  @Test
  void devicesAreReadWithIt() throws IOException {
    SceneFile scene =
        SceneFile.of("cell.scene.json", "{\"devices\": [{\"type\": \"two-finger\"}]}");

    assertEquals("cell.scene.json, 0 objects, 1 device", scene.words());
    assertEquals(
        scene.equipment(), scene.in(ControllerOptions.headless()).equipment(), scene.toString());
  }

  @Test
  void aDeviceThatIsWrongIsToldWithItsPlace() {
    String why =
        assertThrows(
                IOException.class,
                () -> SceneFile.of("cell.scene.json", "{\"devices\": [{\"type\": \"hand\"}]}"))
            .getMessage();

    assertTrue(why.startsWith("cell.scene.json:1:23: type is \"hand\""), why);
  }

  @Test
  void whatIsWrongIsToldWithItsPlace() throws IOException {
    Path file =
        Files.writeString(folder.resolve("cell.scene.json"), "{\n  \"objects\": [{\"type\": 1}]}");

    String why = assertThrows(IOException.class, () -> SceneFile.read(file)).getMessage();

    assertTrue(why.startsWith(file + ":2:24: "), why);
  }

  @Test
  void aMissingFileIsNamed() {
    Path file = folder.resolve("gone.scene.json");

    String why = assertThrows(IOException.class, () -> SceneFile.read(file)).getMessage();

    assertTrue(why.startsWith(file + ": "), why);
  }

  @Test
  void scenesAreKnownByTheirEnding() {
    assertTrue(SceneFile.hasEnding(Path.of("Cell.Scene.JSON")));
    assertFalse(SceneFile.hasEnding(Path.of("safety.json")));
  }

  @Test
  void eachInstallationHasTheSceneThatWasThereLast() {
    Settings settings = new MemorySettings();
    Path cell = folder.resolve("cell.pinst");
    SceneMemory memory = new SceneMemory(settings);
    assertEquals(Optional.empty(), memory.of(Optional.of(cell)));

    memory.put(Optional.of(cell), Optional.of(folder.resolve("a.scene.json")));
    memory.put(Optional.empty(), Optional.of(folder.resolve("b.scene.json")));
    memory.put(Optional.of(cell), Optional.of(folder.resolve("c.scene.json")));

    SceneMemory later = new SceneMemory(settings);
    assertEquals(Optional.of(folder.resolve("c.scene.json")), later.of(Optional.of(cell)));
    assertEquals(Optional.of(folder.resolve("b.scene.json")), later.of(Optional.empty()));
  }

  @Test
  void thatASceneWasClosedIsRememberedToo() {
    Settings settings = new MemorySettings();
    new SceneMemory(settings).put(Optional.empty(), Optional.empty());

    assertEquals(Optional.of(Path.of("")), new SceneMemory(settings).of(Optional.empty()));
  }

  @Test
  void onlySoManyInstallationsAreRemembered() {
    Settings settings = new MemorySettings();
    SceneMemory memory = new SceneMemory(settings);
    for (int i = 0; i < 150; i++) {
      memory.put(Optional.of(folder.resolve(i + ".pinst")), Optional.empty());
    }

    assertEquals(100, settings.get(SceneMemory.SETTING).orElseThrow().lines().count());
    assertEquals(
        Optional.of(Path.of("")),
        new SceneMemory(settings).of(Optional.of(folder.resolve("149.pinst"))));
  }
}
