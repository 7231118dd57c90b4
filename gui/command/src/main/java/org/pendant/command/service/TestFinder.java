package org.pendant.command.service;

import static org.pendant.command.service.GoldenTexts.text;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Finder of test files: files as they are named, and in folders all whose name ends so. */
public final class TestFinder {
  /** What the names of test files end with. */
  public static final String ENDING = "_test.script";

  /** How deep folders are searched. */
  private static final int MAX_DEPTH = 32;

  private TestFinder() {}

  /**
   * The test files of some paths, sorted, none twice; names have {@code /} on every system.
   *
   * @param paths files and folders
   * @throws IOException if one is not there, or a folder cannot be read; the message says which
   */
  public static List<String> find(List<String> paths) throws IOException {
    SortedSet<String> found = new TreeSet<>();
    for (String each : paths) {
      Path path = Path.of(each);
      if (Files.isDirectory(path)) {
        try (Stream<Path> inside = Files.walk(path, MAX_DEPTH)) {
          inside
              .filter(file -> file.getFileName().toString().endsWith(ENDING))
              .filter(Files::isRegularFile)
              .forEach(file -> found.add(name(file)));
        } catch (UncheckedIOException e) {
          throw e.getCause();
        }
      } else if (Files.exists(path)) {
        found.add(name(path));
      } else {
        throw new IOException(text("noSuchFile", each));
      }
    }
    return List.copyOf(found);
  }

  private static String name(Path path) {
    return path.normalize().toString().replace('\\', '/');
  }
}
