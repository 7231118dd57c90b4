package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.models.json.Json;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.mesh.MeshUnit;
import org.pendant.models.mesh.TriangleMesh;

/**
 * Mesh part: the triangles of a file.
 *
 * @param file its name from the folder of the scene on; {@code /} is between folders
 * @param unit what its numbers count
 * @param triangles what it says, m
 */
public record MeshPart(String file, MeshUnit unit, TriangleMesh triangles) {
  /**
   * Checks the name.
   *
   * @throws IllegalArgumentException if it is no file in the folder of the scene
   */
  public MeshPart {
    Optional<String> refusal = refusal(file);
    if (refusal.isPresent()) {
      throw new IllegalArgumentException(refusal.get());
    }
  }

  /** Those of objects, also of their parts. */
  public static List<MeshPart> of(Stream<SceneObject> objects) {
    return objects
        .flatMap(each -> each.pieces().stream())
        .flatMap(
            each -> each instanceof SceneObject.Mesh mesh ? Stream.of(mesh.part()) : Stream.empty())
        .toList();
  }

  /** Why a name cannot be that of a file; empty if it can. */
  static Optional<String> refusal(String file) {
    boolean elsewhere =
        file.startsWith("/")
            || file.indexOf('\\') >= 0
            || file.indexOf(':') >= 0
            || List.of(file.split("/", -1)).contains("..");
    if (elsewhere) {
      return Optional.of(text("meshElsewhere", Json.quoted(file)));
    }
    return MeshFile.hasEnding(file)
        ? Optional.empty()
        : Optional.of(text("meshEnding", Json.quoted(file), MeshFile.mustEnd()));
  }
}
