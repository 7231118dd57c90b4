package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Mesh file: reads triangles of the formats that are known, by how a file is called. */
public final class MeshFile {
  /** A file has at most this many bytes. */
  public static final int MAX_BYTES = 32 << 20;

  private MeshFile() {}

  /** How names of meshes end. */
  public static final List<String> ENDINGS = List.of("stl", "obj", "glb", "gltf");

  /** These endings, for messages. */
  public static String mustEnd() {
    return text("mustEnd");
  }

  /** Whether a file is called as meshes are. */
  public static boolean hasEnding(String name) {
    return ENDINGS.contains(ending(name));
  }

  /** The unit of files that are called so, if their format has one. */
  public static Optional<MeshUnit> unit(String name) {
    return ending(name).startsWith("gl") ? Optional.of(MeshUnit.METRE) : Optional.empty();
  }

  private static String ending(String name) {
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }

  /**
   * Reads a file that is all there is.
   *
   * @throws MeshException if it is no mesh of a solid
   */
  public static TriangleMesh read(String name, byte[] bytes, MeshUnit unit) throws MeshException {
    return read(name, bytes, unit, MeshNeighbours.NONE);
  }

  /**
   * Reads a file.
   *
   * @param name how it is called
   * @param bytes all of it
   * @param unit what its numbers count
   * @param beside the files that it may name
   * @throws MeshException if it is no mesh of a solid
   */
  public static TriangleMesh read(String name, byte[] bytes, MeshUnit unit, MeshNeighbours beside)
      throws MeshException {
    return triangles(name, bytes, unit, beside).mesh();
  }

  /**
   * Looks at a file, which may be no solid.
   *
   * @throws MeshException if it cannot be read
   */
  public static MeshLook look(String name, byte[] bytes, MeshUnit unit, MeshNeighbours beside)
      throws MeshException {
    return triangles(name, bytes, unit, beside).look();
  }

  private static MeshAssembly triangles(
      String name, byte[] bytes, MeshUnit unit, MeshNeighbours beside) throws MeshException {
    if (bytes.length > MAX_BYTES) {
      throw new MeshException(text("fileTooLong", MAX_BYTES));
    }
    if (!hasEnding(name)) {
      throw new MeshException(text("noMesh", mustEnd()));
    }
    MeshAssembly assembly = new MeshAssembly(unit);
    switch (ending(name)) {
      case "stl" -> StlReader.read(bytes, assembly);
      case "obj" -> new ObjReader(assembly).read(bytes);
      default -> GltfReader.read(bytes, beside, assembly);
    }
    return assembly;
  }
}
