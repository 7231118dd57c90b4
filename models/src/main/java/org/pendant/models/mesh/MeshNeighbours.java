package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.io.IOException;

/** Mesh neighbours: files beside that of a mesh, which it names. */
@FunctionalInterface
public interface MeshNeighbours {
  /** None: those of a mesh that is in no folder. */
  MeshNeighbours NONE =
      name -> {
        throw new IOException(text("noFolder"));
      };

  /**
   * Reads one, but not much more of it than {@link MeshFile#MAX_BYTES}.
   *
   * @param name from the folder of the mesh on, {@code /} between folders
   * @throws IOException if it cannot be read; its message is the reason alone
   */
  byte[] read(String name) throws IOException;
}
