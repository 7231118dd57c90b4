package org.pendant.desktop.shell;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Used folder: where dialogs of a window for files begin: where the program was started, then where
 * files were opened last. One thread uses it, the dispatch thread.
 */
final class UsedFolder {
  private final Path working;
  private final Path home;
  private Optional<Path> last = Optional.empty();

  /** That of a new window. */
  UsedFolder() {
    this(Path.of("").toAbsolutePath(), Path.of(System.getProperty("user.home")));
  }

  UsedFolder(Path working, Path home) {
    this.working = working;
    this.home = home;
  }

  /** Where a dialog begins. Starters of desktops run programs in the root, where nobody works. */
  Path get() {
    return last.orElse(working.getParent() == null ? home : working);
  }

  /** Where a dialog begins for what belongs to some files: beside the first one that there is. */
  Path beside(List<Optional<Path>> files) {
    return files.stream()
        .flatMap(Optional::stream)
        .map(file -> file.toAbsolutePath().getParent())
        .filter(Files::isDirectory)
        .findFirst()
        .orElseGet(this::get);
  }

  /** A file was chosen. */
  void chosen(Path file) {
    last = Optional.ofNullable(file.toAbsolutePath().getParent());
  }
}
