package org.pendant.controller.disk;

import java.io.IOException;
import java.nio.file.Path;

/** Disk: what writing safely asks of the file system; tests have one that fails. */
interface Disk {

  /**
   * Creates a file.
   *
   * @throws java.nio.file.FileAlreadyExistsException if there is one
   */
  OpenFile create(Path file, Rights rights) throws IOException;

  /**
   * Opens a file that is there, to write behind its first bytes; what follows them is cut off.
   *
   * @param length how many bytes of it stay
   */
  OpenFile reopen(Path file, long length) throws IOException;

  /** Opens what is no regular file, such as a pipe or a device, to write into it. */
  OpenFile openSpecial(Path file) throws IOException;

  /** Renames a file in its folder; one of the new name is replaced in the same moment. */
  void replace(Path from, Path to) throws IOException;

  /**
   * Renames a file in its folder.
   *
   * @throws java.nio.file.FileAlreadyExistsException if there is one of the new name
   */
  void rename(Path from, Path to) throws IOException;

  /** Has the entries of a folder written to the disk, where the system can do that. */
  void syncFolder(Path folder);

  /** Removes a file, if it is there. */
  void remove(Path file) throws IOException;
}
