package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.mesh.MeshUnit;

/** Mesh reader: reads the meshes that a scene names, each file once. */
final class MeshReader {
  private final MeshFiles files;
  private final Map<Wanted, MeshPart> known = new HashMap<>();

  private record Wanted(String file, MeshUnit unit) {}

  MeshReader(MeshFiles files) {
    this.files = files;
  }

  /**
   * The part of an object.
   *
   * @param whole the object
   */
  MeshPart part(Json whole, JsonFields object) throws JsonException {
    Json.Text file = object.text("mesh");
    Optional<String> refusal = MeshPart.refusal(file.value());
    if (refusal.isPresent()) {
      throw file.place().refusal(refusal.get());
    }
    Wanted wanted = new Wanted(file.value(), unit(file.value(), whole, object));
    MeshPart part = known.get(wanted);
    if (part == null) {
      part = read(wanted, file);
      known.put(wanted, part);
    }
    return part;
  }

  private static MeshUnit unit(String file, Json whole, JsonFields object) throws JsonException {
    if (object.optional("unit").isEmpty()) {
      if (MeshFile.unit(file).isPresent()) {
        return MeshFile.unit(file).get();
      }
      throw whole.place().refusal(text("unitMissing"));
    }
    Json.Text word = object.text("unit");
    Optional<MeshUnit> unit = MeshUnit.of(word.value());
    if (unit.isEmpty()) {
      throw word.place().refusal(text("unknownUnit", word.described()));
    }
    return unit.get();
  }

  private MeshPart read(Wanted wanted, Json.Text file) throws JsonException {
    try {
      return new MeshPart(wanted.file(), wanted.unit(), files.read(wanted.file(), wanted.unit()));
    } catch (IOException | MeshException e) {
      throw file.place().refusal(wanted.file() + ": " + e.getMessage());
    }
  }
}
