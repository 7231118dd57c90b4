package org.pendant.controller.disk;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Atomic file writer: a name has the old file or all of the new one, whatever happens meanwhile,
 * loss of power included. When something fails, the disk is full for example, the old file is
 * untouched, and where there was none there is none.
 *
 * <p>Symbolic links are followed. A file that is replaced hands on its rights; other hard links to
 * it keep the old text. Pipes and devices are written straight.
 */
public final class AtomicFile {
  private AtomicFile() {}

  /** Writes the bytes of a file. */
  @FunctionalInterface
  public interface Content {
    /** Writes all of them; the stream is buffered, and may be closed or not. */
    void writeTo(OutputStream out) throws IOException;
  }

  /**
   * Writes a file, in place of one that is there. Folders are made.
   *
   * @throws IOException if it cannot be written; its message is the file and the reason, and the
   *     old one is still there then
   */
  public static void write(Path path, byte[] bytes) throws IOException {
    write(path, out -> out.write(bytes));
  }

  /** As {@link #write(Path, byte[])}, for what would be much to keep in memory. */
  public static void write(Path path, Content content) throws IOException {
    write(new SystemDisk(), path, content, Rights.USUAL);
  }

  /**
   * As {@link #write(Path, byte[])}; a file that was not there is one that only its owner reads.
   */
  public static void writePrivate(Path path, byte[] bytes) throws IOException {
    write(new SystemDisk(), path, out -> out.write(bytes), Rights.PRIVATE);
  }

  static void write(Disk disk, Path path, Content content, Rights rights) throws IOException {
    try {
      Path folder = WritePlace.of(path).folder();
      if (!Files.exists(folder)) {
        Files.createDirectories(folder);
      }
      fill(FileDraft.begin(disk, path, true, rights), content);
    } catch (IOException e) {
      throw FileTrouble.of(path, e);
    }
  }

  /**
   * Writes a file that is not there yet.
   *
   * @throws IOException if it is there, or cannot be written; its message is the file and the
   *     reason
   */
  public static void create(Path path, Content content) throws IOException {
    create(new SystemDisk(), path, content);
  }

  static void create(Disk disk, Path path, Content content) throws IOException {
    try {
      fill(FileDraft.begin(disk, path, false, Rights.USUAL), content);
    } catch (IOException e) {
      throw FileTrouble.of(path, e);
    }
  }

  private static void fill(FileDraft draft, Content content) throws IOException {
    try (draft) {
      content.writeTo(draft.out());
      draft.commit();
    }
  }
}
