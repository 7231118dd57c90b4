package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.MeshLook;
import org.pendant.models.mesh.MeshUnit;
import org.pendant.models.mesh.TriangleMesh;

/** Mesh files: where a scene has the meshes from that it names. */
@FunctionalInterface
public interface MeshFiles {
  /** No files: those of a text that is in no folder. */
  MeshFiles NONE =
      (name, unit) -> {
        throw new IOException(text("noFolder"));
      };

  /**
   * Reads one.
   *
   * @param name of the file, from the folder of the scene on
   * @throws IOException if it cannot be read; its message is the reason alone
   * @throws MeshException if it is no mesh
   */
  TriangleMesh read(String name, MeshUnit unit) throws IOException, MeshException;

  /** The files in a folder, and in those below it. */
  static MeshFiles in(Path folder) {
    return new MeshFolder(folder);
  }

  /**
   * Looks at a file in a folder, which may be no solid.
   *
   * @param name from the folder on
   * @throws IOException if it cannot be read; its message is the reason alone
   * @throws MeshException if it is no mesh at all
   */
  static MeshLook look(Path folder, String name, MeshUnit unit) throws IOException, MeshException {
    return new MeshFolder(folder).look(name, unit);
  }

  /**
   * The file of a mesh, and those beside it that it names: all that has to go along with it.
   *
   * @param name from the folder on, as the others
   * @throws IOException if one cannot be read
   */
  static List<String> named(Path folder, String name) throws IOException {
    return new MeshFolder(folder).named(name);
  }

  /**
   * Those that a scene has already, for reading what was written of it.
   *
   * @param ofArms those of arms that have a tool of their own
   */
  static MeshFiles of(Scene scene, List<MeshPart> ofArms) {
    List<MeshPart> all = new ArrayList<>(scene.meshes());
    all.addAll(ofArms);
    return (name, unit) -> {
      for (MeshPart mesh : all) {
        if (mesh.file().equals(name) && mesh.unit() == unit) {
          return mesh.triangles();
        }
      }
      throw new IOException(text("fileNotThere"));
    };
  }
}
