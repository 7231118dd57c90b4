package org.pendant.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.command.service.TestFinder;

/** Changes of files: whether one of several has changed, or a file of tests has come or gone. */
final class FileChanges {
  private final Collection<String> names;
  private final List<String> paths;
  private final Map<String, Optional<FileTime>> times;
  private final List<String> tests;

  /**
   * The files as they are now.
   *
   * @param names of those that are looked at
   * @param paths where files of tests are looked for; empty for this folder
   */
  FileChanges(Collection<String> names, List<String> paths) {
    this.names = names;
    this.paths = paths.isEmpty() ? List.of(".") : paths;
    times = times();
    tests = tests();
  }

  /** Whether anything is otherwise now. */
  boolean any() {
    return !times.equals(times()) || !tests.equals(tests());
  }

  private Map<String, Optional<FileTime>> times() {
    Map<String, Optional<FileTime>> now = new HashMap<>();
    for (String name : names) {
      now.put(name, time(Path.of(name)));
    }
    return now;
  }

  private static Optional<FileTime> time(Path path) {
    try {
      return Optional.of(Files.getLastModifiedTime(path));
    } catch (IOException e) {
      // it is gone, which is a change as well
      return Optional.empty();
    }
  }

  private List<String> tests() {
    try {
      return TestFinder.find(paths);
    } catch (IOException e) {
      // a folder that is gone has none
      return List.of();
    }
  }
}
