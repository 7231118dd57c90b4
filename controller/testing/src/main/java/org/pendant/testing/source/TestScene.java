package org.pendant.testing.source;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.world.Scene;
import org.pendant.models.json.JsonException;
import org.pendant.models.mesh.MeshFile;

/**
 * Test scene: what stands around the arm of a test, and which other controllers work there.
 *
 * @param name of the file
 * @param plan what is in it
 */
public record TestScene(String name, CellPlan plan) {
  /**
   * Reads one.
   *
   * @throws IOException if the file cannot be read
   * @throws JsonException for the first thing that is wrong in it
   */
  static TestScene read(TestSources files, String name) throws IOException, JsonException {
    byte[] file = files.read(name);
    return new TestScene(
        name,
        CellPlan.read(
            name,
            new ByteArrayInputStream(file),
            (mesh, unit) -> MeshFile.read(mesh, files.read(TestSources.beside(name, mesh)), unit)));
  }

  /** Whether the controller of the test is alone in it. */
  public boolean alone() {
    return plan.layout().alone();
  }

  /** What the tool can touch. */
  public Scene scene() {
    return plan.scene();
  }

  /** What answers the program. */
  public CellEquipment equipment() {
    return plan.equipment().ofFirst();
  }
}
