package org.pendant.testing.source;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.mesh.MeshFile;

/**
 * Test scene: what stands around the arm of a test.
 *
 * @param scene what the tool can touch
 * @param equipment what answers the program
 */
public record TestScene(Scene scene, CellEquipment equipment) {
  /**
   * Reads one.
   *
   * @throws IOException if the file cannot be read
   * @throws JsonException for the first thing that is wrong in it
   */
  static TestScene read(TestSources files, String name) throws IOException, JsonException {
    byte[] file = files.read(name);
    return new TestScene(
        SceneReader.read(
            name,
            new ByteArrayInputStream(file),
            (mesh, unit) -> MeshFile.read(mesh, files.read(TestSources.beside(name, mesh)), unit)),
        EquipmentReader.read(name, new ByteArrayInputStream(file)));
  }
}
