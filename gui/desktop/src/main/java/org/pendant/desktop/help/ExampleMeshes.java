package org.pendant.desktop.help;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Example meshes: files of meshes that come with a scene.
 *
 * @param files their names from the folder of the scene on
 */
public record ExampleMeshes(List<String> files) {
  /** Those of a scene that names none. */
  public static final ExampleMeshes NONE = new ExampleMeshes(List.of());

  /** Copies the list. */
  public ExampleMeshes {
    files = List.copyOf(files);
  }

  /**
   * Writes them into a new folder, which goes when the program ends; not for the dispatch thread.
   *
   * @throws IOException if that cannot be
   */
  public Path unpack() throws IOException {
    Path folder = Files.createTempDirectory("pendant-example");
    folder.toFile().deleteOnExit();
    for (String name : files) {
      Path file = folder.resolve(name);
      for (Path each = file.getParent(); !each.equals(folder); each = each.getParent()) {
        Files.createDirectories(each);
        each.toFile().deleteOnExit();
      }
      Files.write(file, HelpTexts.bytes("examples/" + name));
      file.toFile().deleteOnExit();
    }
    return folder;
  }
}
