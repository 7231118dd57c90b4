package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

final class SceneReaderTest {
  /** Tests run in the folder of their module. */
  private static final Path PROJECT = Path.of("../..");

  private static Scene read(String text) throws JsonException {
    return SceneReader.read(
        "scene.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static String example() throws IOException {
    return Files.readString(PROJECT.resolve("examples/table.scene.json"));
  }

  @Test
  void exampleIsReadAsItStands() throws Exception {
    assertEquals(
        new Scene(
            List.of(
                new SceneObject.Plane(
                    "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
                new SceneObject.Box(
                    "fixture",
                    new Pose(0.45, -0.2, 0.03, 0, 0, Math.PI / 4),
                    new Vector3(0.2, 0.1, 0.06),
                    new Material(1e5, 0.2, 0.15)),
                new SceneObject.Sphere(
                    "ball", new Vector3(0.3, 0.35, 0.05), 0.05, new Material(5000, 0.6, 0.8))),
            Optional.of(new Payload(1.2, 0, 0.01, 0.06, 0.003, 0.003, 0.001, 0, 0, 0)),
            List.of()),
        read(example()));
  }

  @Test
  void documentationShowsTheExample() throws Exception {
    String page = Files.readString(PROJECT.resolve("docs/scene.md"));
    assertTrue(
        page.contains("```json\n" + example() + "```\n"),
        "copy examples/table.scene.json into docs/scene.md");
  }

  @Test
  void documentationsToolIsRead() throws Exception {
    String page = Files.readString(PROJECT.resolve("docs/scene.md"));
    int start = page.indexOf("```json\n", page.indexOf("\n## tool\n")) + "```json\n".length();
    assertEquals(
        List.of(
            new ToolPoint(new Vector3(-0.04, 0, 0.15), 0),
            new ToolPoint(new Vector3(0.04, 0, 0.15), 0.005)),
        read(page.substring(start, page.indexOf("```", start))).toolPoints());
  }

  @Test
  void everythingMayBeLeftOut() throws Exception {
    assertEquals(Scene.EMPTY, read("{}"));
  }

  @Test
  void loadNeedsOnlyAMass() throws Exception {
    assertEquals(Optional.of(Payload.of(3, 0, 0, 0)), read("{\"load\": {\"mass\": 3}}").load());
  }

  @Test
  void markThatSomeEditorsPutFirstIsPassedOver() throws Exception {
    assertEquals(Scene.EMPTY, read("\ufeff{}"));
  }

  @Test
  void inertiaOfALongRodIsPossible() throws Exception {
    // a rod along x + y + z: as much as a body can have across, and nothing along it
    String rod = "[0.2, 0.2, 0.2, -0.1, -0.1, -0.1]";
    assertEquals(
        -0.1,
        read("{\"load\": {\"mass\": 1, \"inertia\": " + rod + "}}").load().orElseThrow().ixy());
  }

  @Test
  void aPushActsFromTheStart() throws Exception {
    Scene scene = read("{\"push\": {\"force\": [0, 0, -20], \"torque\": [1, 2, 3]}}");
    assertEquals(new Wrench(0, 0, -20, 1, 2, 3), scene.pushAtTcpInBase());
    assertEquals(new Wrench(0, 0, -20, 1, 2, 3), new ContactWorld(scene).applied());
    assertEquals(Wrench.ZERO, read("{}").pushAtTcpInBase());
    assertEquals(
        new Wrench(0, 5, 0, 0, 0, 0), read("{\"push\": {\"force\": [0, 5, 0]}}").pushAtTcpInBase());
  }

  @Test
  void aPushThatNoArmCouldFeelIsRefusedWithItsPlace() {
    JsonException refused =
        assertThrows(JsonException.class, () -> read("{\"push\": {\"force\": [0, 0, 20000]}}"));
    assertTrue(refused.getMessage().startsWith("scene.json:1:"), refused.getMessage());
    assertTrue(refused.getMessage().contains("-10000 to 10000"), refused.getMessage());
  }
}
