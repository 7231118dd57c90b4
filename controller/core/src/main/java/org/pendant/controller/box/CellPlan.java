package org.pendant.controller.box;

import java.io.InputStream;
import java.util.List;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.layout.CellLayout;
import org.pendant.controller.layout.LayoutReader;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Plan of a cell: all that is in the file of a scene.
 *
 * @param fileName for messages
 * @param scene in the frame of the cell
 * @param layout which controllers there are
 * @param equipment what answers their programs
 */
public record CellPlan(String fileName, Scene scene, CellLayout layout, EquipmentPlan equipment) {
  /**
   * Reads all of {@code in}, which the caller closes.
   *
   * @param fileName for messages
   * @param meshes the files that it may name
   * @throws JsonException for the first thing that is wrong, with its place; also if the file
   *     cannot be read or is too large
   */
  public static CellPlan read(String fileName, InputStream in, MeshFiles meshes)
      throws JsonException {
    Json file = JsonFile.read(fileName, in);
    Scene scene = SceneReader.read(file, meshes);
    JsonFields fields = new JsonFields(file, "a scene");
    CellLayout layout = LayoutReader.read(fields, meshes);
    return new CellPlan(fileName, scene, layout, EquipmentReader.plan(fields, layout));
  }

  /** The meshes of arms that have a tool of their own. */
  public List<MeshPart> meshesOfArms() {
    return MeshPart.of(
        layout.arms().stream()
            .flatMap(arm -> arm.tool().stream())
            .flatMap(tool -> tool.bodies().stream()));
  }

  /** The arms, also the only one of which the file says nothing. */
  public List<ArmEntry> arms() {
    return layout.arms().isEmpty()
        ? List.of(ArmEntry.only(new FilePosition(fileName, 1, 1)))
        : layout.arms();
  }
}
