package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;

/**
 * Scene move: what becomes of the meshes that a scene names when it is saved in another folder.
 * Those that are in the new folder, or below, are named from there; others have to be copied, to
 * where the same names lead.
 *
 * @param from the folder that it was read from
 * @param to the folder that it is saved in
 */
public record SceneMove(Path from, Path to) {
  /** Both folders as they are whatever the working folder is. */
  public SceneMove {
    from = from.toAbsolutePath().normalize();
    to = to.toAbsolutePath().normalize();
  }

  /** The scene with the names that lead to the same meshes from the new folder. */
  public Scene renamed(Scene scene) {
    return from.equals(to)
        ? scene
        : scene
            .withObjects(scene.objects().stream().map(this::renamed).toList())
            .withToolBodies(scene.toolBodies().stream().map(this::renamed).toList());
  }

  private SceneObject renamed(SceneObject object) {
    if (object instanceof SceneObject.Compound compound) {
      return compound.of(compound.parts().stream().map(this::renamed).toList());
    }
    if (!(object instanceof SceneObject.Mesh mesh) || !within(mesh.part().file())) {
      return object;
    }
    Path there = to.relativize(from.resolve(mesh.part().file()));
    MeshPart part =
        new MeshPart(
            there.toString().replace('\\', '/'), mesh.part().unit(), mesh.part().triangles());
    return new SceneObject.Mesh(
        mesh.name(), mesh.poseInBase(), part, mesh.material(), mesh.massKg());
  }

  private boolean within(String file) {
    return from.resolve(file).normalize().startsWith(to);
  }

  /**
   * Files of meshes that have to be copied; empty if none.
   *
   * @param kept those that are named as before, wherever they are: of the tools of arms
   */
  public List<String> toCopy(Scene scene, List<MeshPart> kept) {
    Set<String> files = new LinkedHashSet<>();
    for (MeshPart mesh : scene.meshes()) {
      if (!within(mesh.file())) {
        files.add(mesh.file());
      }
    }
    if (!from.equals(to)) {
      kept.forEach(mesh -> files.add(mesh.file()));
    }
    return List.copyOf(files);
  }

  /**
   * Copies files of meshes, and those that they name; not for the dispatch thread. Replaces
   * nothing: what is there already must be the same.
   *
   * @throws IOException if that cannot be; nothing was copied then if another file is in the way
   */
  public void copy(List<String> meshes) throws IOException {
    Set<String> all = new LinkedHashSet<>();
    for (String mesh : meshes) {
      all.addAll(MeshFiles.named(from, mesh));
    }
    List<String> missing = new ArrayList<>();
    for (String file : all) {
      Path target = to.resolve(file);
      if (!Files.exists(target)) {
        missing.add(file);
      } else if (!Arrays.equals(
          Files.readAllBytes(from.resolve(file)), Files.readAllBytes(target))) {
        throw new IOException(text("isAnotherFile", target));
      }
    }
    for (String file : missing) {
      Path target = to.resolve(file);
      Files.createDirectories(target.getParent());
      AtomicFile.write(target, Files.readAllBytes(from.resolve(file)));
    }
  }
}
