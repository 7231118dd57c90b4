package org.pendant.controller.disk;

import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/** System disk: the file systems of this machine. */
final class SystemDisk implements Disk {

  @Override
  public OpenFile create(Path file, Rights rights) throws IOException {
    rights.create(file);
    try {
      return new Regular(new RandomAccessFile(file.toFile(), "rw"));
    } catch (IOException e) {
      Files.deleteIfExists(file);
      throw e;
    }
  }

  @Override
  public OpenFile reopen(Path file, long length) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new NoSuchFileException(file.toString());
    }
    RandomAccessFile opened = new RandomAccessFile(file.toFile(), "rw");
    try {
      Regular regular = new Regular(opened);
      regular.cut(length);
      return regular;
    } catch (IOException e) {
      opened.close();
      throw e;
    }
  }

  @Override
  public OpenFile openSpecial(Path file) throws IOException {
    // what standard output was redirected to may have something in it: that stays
    return new Special(
        Files.newOutputStream(file, StandardOpenOption.WRITE, StandardOpenOption.APPEND));
  }

  @Override
  public void replace(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  @Override
  public void rename(Path from, Path to) throws IOException {
    try {
      // moving would replace a file that has come in the last moment
      Files.createLink(to, from);
      Files.delete(from);
    } catch (FileAlreadyExistsException e) {
      throw e;
    } catch (IOException | UnsupportedOperationException e) {
      Files.move(from, to); // this file system has no hard links
    }
  }

  @Override
  public void syncFolder(Path folder) {
    try (FileChannel entries = FileChannel.open(folder, StandardOpenOption.READ)) {
      entries.force(true);
    } catch (IOException e) {
      // The file is there, and whole. Some systems cannot do more.
    }
  }

  @Override
  public void remove(Path file) throws IOException {
    Files.deleteIfExists(file);
  }

  private record Regular(RandomAccessFile file) implements OpenFile {
    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      file.write(bytes, from, count);
    }

    @Override
    public void cut(long length) throws IOException {
      file.setLength(length);
      file.seek(length);
    }

    @Override
    public void sync() throws IOException {
      file.getFD().sync();
    }

    @Override
    public void close() throws IOException {
      file.close();
    }
  }

  /** What takes bytes and gives none back. */
  private record Special(OutputStream out) implements OpenFile {
    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      out.write(bytes, from, count);
    }

    @Override
    public void cut(long length) {
      // what has gone through is gone
    }

    @Override
    public void sync() {
      // there is no disk behind it
    }

    @Override
    public void close() throws IOException {
      out.close();
    }
  }
}
