package org.pendant.controller.disk;

import static org.pendant.controller.disk.DiskTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Draft of a file that is being written. It is written beside the place where it will be, with a
 * hidden name, and takes that place when it is committed. Closing it before that removes it. One
 * thread uses it.
 */
public final class FileDraft implements Closeable {
  private static final int BUFFER_BYTES = 1 << 16;

  private final Disk disk;
  private final WritePlace place;
  private final boolean mayReplace;
  private final Path beside;
  private final OpenFile file;
  private final OutputStream out = new Buffered();
  private boolean failed;
  private boolean closed;

  private FileDraft(Disk disk, WritePlace place, boolean mayReplace, Rights rights)
      throws IOException {
    this.disk = disk;
    this.place = place;
    this.mayReplace = mayReplace;
    if (place.special()) {
      beside = place.path();
      file = disk.openSpecial(place.path());
      return;
    }
    beside = place.beside();
    file = disk.create(beside, place.occupied() ? Rights.of(place.path()) : rights);
  }

  /**
   * Begins a file that takes the place of one that may be there.
   *
   * @throws IOException if nothing can be written there
   */
  public static FileDraft replacing(Path path) throws IOException {
    return begin(new SystemDisk(), path, true, Rights.USUAL);
  }

  /**
   * Begins a file.
   *
   * @param mayReplace whether there may be one of that name, now and when it is committed
   * @param rights of a file where none was
   */
  static FileDraft begin(Disk disk, Path path, boolean mayReplace, Rights rights)
      throws IOException {
    WritePlace place = WritePlace.of(path);
    place.check();
    if (!mayReplace && place.occupied()) {
      throw new FileAlreadyExistsException(path.toString());
    }
    return new FileDraft(disk, place, mayReplace, rights);
  }

  /** Where it is until it is committed. */
  public Path beside() {
    return beside;
  }

  /** Where its bytes go, with a buffer. Closing the stream ends nothing. */
  public OutputStream out() {
    return out;
  }

  private void put(byte[] bytes, int from, int count) throws IOException {
    if (closed) {
      throw new IOException(text("closed"));
    }
    try {
      file.write(bytes, from, count);
    } catch (IOException e) {
      failed = true;
      throw e;
    }
  }

  /**
   * Puts it in its place, all of it on the disk.
   *
   * @throws IOException if that fails, or writing has failed before; what was there is untouched
   */
  public void commit() throws IOException {
    if (failed) {
      throw new IOException(text("notWhole"));
    }
    try {
      out.flush();
      file.sync();
      closed = true;
      file.close();
      if (place.special()) {
        return;
      }
      if (mayReplace) {
        disk.replace(beside, place.path());
      } else {
        disk.rename(beside, place.path());
      }
      disk.syncFolder(place.folder());
    } catch (IOException e) {
      abandon();
      throw e;
    }
  }

  /** Removes it, unless it was committed. */
  @Override
  public void close() throws IOException {
    if (!closed) {
      abandon();
    }
  }

  private void abandon() throws IOException {
    closed = true;
    try {
      file.close();
    } finally {
      if (!place.special()) {
        disk.remove(beside);
      }
    }
  }

  private final class Buffered extends OutputStream {
    private final byte[] buffer = new byte[BUFFER_BYTES];
    private int buffered;

    @Override
    public void write(int value) throws IOException {
      if (buffered == buffer.length) {
        flush();
      }
      buffer[buffered] = (byte) value;
      buffered++;
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      Objects.checkFromIndexSize(from, count, bytes.length);
      if (count > buffer.length - buffered) {
        flush();
      }
      if (count >= buffer.length) {
        put(bytes, from, count);
        return;
      }
      System.arraycopy(bytes, from, buffer, buffered, count);
      buffered += count;
    }

    @Override
    public void flush() throws IOException {
      int count = buffered;
      buffered = 0;
      if (count > 0) {
        put(buffer, 0, count);
      }
    }

    @Override
    public void close() throws IOException {
      flush();
    }
  }
}
