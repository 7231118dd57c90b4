package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.mesh.MeshLook;
import org.pendant.models.mesh.MeshNeighbours;
import org.pendant.models.mesh.MeshUnit;
import org.pendant.models.mesh.TriangleMesh;

/** Mesh folder: the files of meshes in a folder and below it; links do not lead out of it. */
record MeshFolder(Path folder) implements MeshFiles {

  @Override
  public TriangleMesh read(String name, MeshUnit unit) throws IOException, MeshException {
    return MeshFile.read(name, bytes(name), unit, beside(name));
  }

  /** What can be told of a file; its message is the reason alone where it cannot be read. */
  MeshLook look(String name, MeshUnit unit) throws IOException, MeshException {
    return MeshFile.look(name, bytes(name), unit, beside(name));
  }

  /** The file of a mesh and those that it names, from the folder on. */
  List<String> named(String name) throws IOException {
    List<String> files = new ArrayList<>(List.of(name));
    MeshNeighbours told =
        other -> {
          files.add(name.substring(0, name.lastIndexOf('/') + 1) + other);
          return beside(name).read(other);
        };
    try {
      var _ = MeshFile.look(name, bytes(name), MeshUnit.METRE, told);
    } catch (MeshException e) {
      throw new IOException(name + ": " + e.getMessage(), e);
    }
    return files;
  }

  /** The files beside that of a mesh. */
  private MeshNeighbours beside(String name) {
    String within = name.substring(0, name.lastIndexOf('/') + 1);
    return other -> bytes(within + other);
  }

  private byte[] bytes(String name) throws IOException {
    try {
      Path root = folder.toRealPath();
      Path file = root.resolve(name).toRealPath();
      if (!file.startsWith(root)) {
        throw new IOException(text("linkLeadsOut"));
      }
      if (!Files.isRegularFile(file)) {
        throw new IOException(text("notAFile"));
      }
      try (InputStream in = Files.newInputStream(file)) {
        // one more than it may have, so that its reader refuses it
        return in.readNBytes(MeshFile.MAX_BYTES + 1);
      }
    } catch (NoSuchFileException | NotDirectoryException e) {
      throw new IOException(text("fileNotThere"), e);
    } catch (AccessDeniedException e) {
      throw new IOException(text("noPermission"), e);
    } catch (InvalidPathException e) {
      throw new IOException(text("notAFileName"), e);
    }
  }
}
