package org.pendant.controller.disk;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The disk, until it has no more room or breaks: after some steps each further one fails. */
final class FailingDisk implements Disk {
  private final Disk disk = new SystemDisk();
  private final List<String> steps = new ArrayList<>();
  private final int working;

  /** One of which {@code working} steps work. */
  FailingDisk(int working) {
    this.working = working;
  }

  /** What was tried. */
  List<String> steps() {
    return steps;
  }

  boolean hasFailed() {
    return steps.size() > working;
  }

  private void step(String name) throws IOException {
    steps.add(name);
    if (hasFailed()) {
      throw new IOException("No space left on device");
    }
  }

  @Override
  public OpenFile create(Path file, Rights rights) throws IOException {
    step("create");
    return new Failing(disk.create(file, rights));
  }

  @Override
  public OpenFile reopen(Path file, long length) throws IOException {
    step("reopen");
    return new Failing(disk.reopen(file, length));
  }

  @Override
  public OpenFile openSpecial(Path file) throws IOException {
    step("open");
    return new Failing(disk.openSpecial(file));
  }

  @Override
  public void replace(Path from, Path to) throws IOException {
    step("replace");
    disk.replace(from, to);
  }

  @Override
  public void rename(Path from, Path to) throws IOException {
    step("rename");
    disk.rename(from, to);
  }

  @Override
  public void syncFolder(Path folder) {
    steps.add("sync folder");
  }

  /** Works always: what cannot even be removed stays. */
  @Override
  public void remove(Path file) throws IOException {
    disk.remove(file);
  }

  private final class Failing implements OpenFile {
    private final OpenFile file;

    private Failing(OpenFile file) {
      this.file = file;
    }

    /** Like a full disk, it has room for a part of what is written. */
    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      try {
        step("write");
      } catch (IOException e) {
        file.write(bytes, from, count / 2);
        throw e;
      }
      file.write(bytes, from, count);
    }

    @Override
    public void cut(long length) throws IOException {
      file.cut(length);
    }

    @Override
    public void sync() throws IOException {
      step("sync");
      file.sync();
    }

    @Override
    public void close() throws IOException {
      file.close();
    }
  }
}
