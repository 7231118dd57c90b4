package org.pendant.controller.disk;

import static org.pendant.controller.disk.DiskTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;

/**
 * Growing file: it has its name from its first part on, so that its content is found when its
 * process is killed. It grows by whole parts: what was written goes to the file when it is flushed,
 * all of it or, when that fails, nothing. It is never empty. Pipes and devices are written
 * straight. One thread uses it.
 */
public final class GrowingFile extends OutputStream {
  private final Disk disk;
  private final WritePlace place;
  private final OpenFile file;
  private final ByteArrayOutputStream part = new ByteArrayOutputStream();
  private final Path beside;
  private long length;
  private boolean failed;
  private boolean closed;

  private GrowingFile(Disk disk, WritePlace place) throws IOException {
    this.disk = disk;
    this.place = place;
    beside = place.special() ? place.path() : place.beside();
    file = place.special() ? disk.openSpecial(beside) : disk.create(beside, Rights.USUAL);
  }

  private GrowingFile(Disk disk, WritePlace place, long kept) throws IOException {
    this.disk = disk;
    this.place = place;
    beside = place.path();
    file = disk.reopen(beside, kept);
    length = kept;
  }

  /**
   * Creates a file.
   *
   * @throws IOException if there is one already, or it cannot be written
   */
  public static GrowingFile create(Path path) throws IOException {
    return create(new SystemDisk(), path);
  }

  /**
   * Goes on with a file that is there, behind its first bytes; what follows them is cut off.
   *
   * @param kept how many bytes of it stay, above 0
   * @throws IOException if there is no such file, or it cannot be written
   */
  public static GrowingFile resume(Path path, long kept) throws IOException {
    return new GrowingFile(new SystemDisk(), WritePlace.of(path), kept);
  }

  static GrowingFile create(Disk disk, Path path) throws IOException {
    WritePlace place = WritePlace.of(path);
    place.check();
    if (place.occupied()) {
      throw new FileAlreadyExistsException(path.toString());
    }
    return new GrowingFile(disk, place);
  }

  @Override
  public void write(int value) {
    part.write(value);
  }

  @Override
  public void write(byte[] bytes, int from, int count) {
    part.write(bytes, from, count);
  }

  /**
   * Ends a part.
   *
   * @throws IOException if it cannot be written; the file then ends with the part before, for good
   */
  @Override
  public void flush() throws IOException {
    if (part.size() == 0) {
      return;
    }
    if (failed || closed) {
      throw new IOException(text("ended"));
    }
    byte[] bytes = part.toByteArray();
    part.reset();
    try {
      file.write(bytes, 0, bytes.length);
      if (length == 0 && !place.special()) {
        disk.rename(beside, place.path());
      }
      length += bytes.length;
    } catch (IOException e) {
      failed = true;
      try {
        file.cut(length);
      } catch (IOException cutting) {
        e.addSuppressed(cutting);
      }
      throw e;
    }
  }

  /** Ends the last part and the file, all of it on the disk. */
  @Override
  public void close() throws IOException {
    if (closed) {
      return;
    }
    try (file) {
      if (!failed) {
        flush();
      }
      file.sync();
    } finally {
      closed = true;
      if (length == 0 && !place.special()) {
        disk.remove(beside);
      }
      disk.syncFolder(place.folder());
    }
  }
}
