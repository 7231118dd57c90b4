package org.pendant.controller.disk;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.GroupPrincipal;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import java.util.Set;

/**
 * File rights: who may do what with a new file.
 *
 * @param permissions empty for those that the system gives to any new file
 * @param group empty for the one that the system gives
 */
record Rights(Optional<Set<PosixFilePermission>> permissions, Optional<GroupPrincipal> group) {
  /** Those of any new file. */
  static final Rights USUAL = new Rights(Optional.empty(), Optional.empty());

  /** Only its owner reads it. */
  static final Rights PRIVATE =
      new Rights(Optional.of(PosixFilePermissions.fromString("rw-------")), Optional.empty());

  /** Those of a file that is there; the usual ones where the file system has none. */
  static Rights of(Path file) throws IOException {
    PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
    if (view == null) {
      return USUAL;
    }
    PosixFileAttributes attributes = view.readAttributes();
    return new Rights(Optional.of(attributes.permissions()), Optional.of(attributes.group()));
  }

  /** Creates an empty file with them. At no time it allows more. */
  void create(Path file) throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    boolean known = folder.getFileSystem().supportedFileAttributeViews().contains("posix");
    if (permissions.isEmpty() || !known) {
      Files.createFile(file);
      return;
    }
    Files.createFile(file, PosixFilePermissions.asFileAttribute(permissions.get()));
    try {
      PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
      if (group.isPresent() && !group.get().equals(view.readAttributes().group())) {
        changeGroup(view);
      }
      view.setPermissions(permissions.get()); // creating it has left out what the umask forbids
    } catch (IOException e) {
      Files.deleteIfExists(file);
      throw e;
    }
  }

  private void changeGroup(PosixFileAttributeView view) {
    try {
      view.setGroup(group.orElseThrow());
    } catch (IOException e) {
      // One may write into files of groups to which one does not belong.
    }
  }
}
