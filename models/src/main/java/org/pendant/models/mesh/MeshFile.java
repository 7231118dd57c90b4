package org.pendant.models.mesh;

import java.util.Locale;

/** Mesh file: reads triangles of the formats that are known, by how a file is called. */
public final class MeshFile {
  /** A file has at most this many bytes. */
  public static final int MAX_BYTES = 32 << 20;

  private MeshFile() {}

  /** Whether a file is called as meshes are. */
  public static boolean hasEnding(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(".stl") || lower.endsWith(".obj");
  }

  /**
   * Reads a file.
   *
   * @param name how it is called
   * @param bytes all of it
   * @param unit what its numbers count
   * @throws MeshException if it is no mesh of a solid
   */
  public static TriangleMesh read(String name, byte[] bytes, MeshUnit unit) throws MeshException {
    if (bytes.length > MAX_BYTES) {
      throw new MeshException(
          "has more than " + MAX_BYTES + " bytes, must be at most that many: export it coarser");
    }
    if (!hasEnding(name)) {
      throw new MeshException("is no mesh that is known: must end with .stl or .obj");
    }
    MeshAssembly assembly = new MeshAssembly(unit);
    if (name.toLowerCase(Locale.ROOT).endsWith(".stl")) {
      StlReader.read(bytes, assembly);
    } else {
      new ObjReader(assembly).read(bytes);
    }
    return assembly.mesh();
  }
}
