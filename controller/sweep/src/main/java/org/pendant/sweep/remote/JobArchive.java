package org.pendant.sweep.remote;

import static org.pendant.sweep.remote.RemoteTexts.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.SweepJob;

/**
 * Job archive: the files of a job in one piece, so that a process on another computer reads the
 * same plan. It has every file that the plan names and all in the folders of the program and of the
 * scene, since these may open files beside them; not what is hidden, and no results of sweeps.
 */
public final class JobArchive {
  private JobArchive() {}

  /**
   * Packs the files of a job.
   *
   * @param plan the file of its plan
   * @return bytes for {@link #unpack}
   * @throws PlanException if a file cannot be read or is named by its whole path, lies in no folder
   *     that the others share, or there are too many
   */
  public static byte[] pack(Path plan, SweepJob job) throws PlanException {
    try {
      Path file = plan.toAbsolutePath().normalize();
      return pack(file, files(file, job));
    } catch (IOException e) {
      throw new PlanException(plan + ": error: " + e.getMessage());
    }
  }

  /**
   * Looks whether the files of a job can be packed, without reading them.
   *
   * @throws PlanException as {@link #pack}
   */
  public static void check(Path plan, SweepJob job) throws PlanException {
    try {
      Path file = plan.toAbsolutePath().normalize();
      root(file, files(file, job));
    } catch (IOException e) {
      throw new PlanException(plan + ": error: " + e.getMessage());
    }
  }

  /** The folder that all files are in. */
  private static Path root(Path plan, SortedSet<Path> files) throws IOException {
    Path root = plan.getParent();
    for (Path each : files) {
      while (root != null && !each.startsWith(root)) {
        root = root.getParent();
      }
    }
    if (root == null) {
      throw new IOException(text("noCommonFolder"));
    }
    return root;
  }

  private static byte[] pack(Path file, SortedSet<Path> files) throws IOException {
    Path root = root(file, files);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      // the first entry is the plan, so that who unpacks it knows which it is
      add(zip, root, file);
      files.remove(file);
      for (Path each : files) {
        add(zip, root, each);
      }
    }
    return bytes.toByteArray();
  }

  private static void add(ZipOutputStream zip, Path root, Path file) throws IOException {
    zip.putNextEntry(new ZipEntry(root.relativize(file).toString().replace('\\', '/')));
    try (InputStream in = Files.newInputStream(file)) {
      in.transferTo(zip);
    } catch (IOException e) {
      throw FileTrouble.of(file, e);
    }
    zip.closeEntry();
  }

  private static SortedSet<Path> files(Path plan, SweepJob job) throws IOException {
    JobFiles files = new JobFiles();
    files.add(plan);
    for (String name : job.files()) {
      if (Path.of(name).isAbsolute()) {
        throw new IOException(text("absoluteFile", name));
      }
      files.add(plan.resolveSibling(name).normalize());
    }
    SweepPlan content = job.plan();
    SortedSet<Path> folders = new TreeSet<>();
    folders.add(plan.resolveSibling(content.program()).normalize().getParent());
    content
        .scene()
        .ifPresent(name -> folders.add(plan.resolveSibling(name).normalize().getParent()));
    for (Path each : folders) {
      files.addAllIn(each);
    }
    return files.all();
  }

  /**
   * Writes the files of an archive below a folder.
   *
   * @param folder an empty one
   * @return the file of the plan
   * @throws IOException if they cannot be written, or it is no such archive
   */
  public static Path unpack(byte[] archive, Path folder) throws IOException {
    Path plan = null;
    Path top = folder.toAbsolutePath().normalize();
    int count = 0;
    long left = JobFiles.MAX_BYTES;
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(archive))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = top.resolve(entry.getName()).normalize();
        count++;
        if (!file.startsWith(top) || entry.isDirectory() || count > JobFiles.MAX_FILES) {
          throw new IOException(text("notOfJob", entry.getName()));
        }
        Files.createDirectories(file.getParent());
        left -= Files.copy(new BoundedStream(zip, left), file);
        plan = plan == null ? file : plan;
      }
    }
    if (plan == null) {
      throw new IOException(text("noPlan"));
    }
    return plan;
  }

  /** A stream that fails behind so many bytes. */
  private static final class BoundedStream extends InputStream {
    private final InputStream in;
    private long left;

    private BoundedStream(InputStream in, long left) {
      this.in = in;
      this.left = left;
    }

    @Override
    public int read() throws IOException {
      int value = in.read();
      count(value < 0 ? 0 : 1);
      return value;
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
      int size = in.read(target, offset, length);
      count(Math.max(size, 0));
      return size;
    }

    private void count(int size) throws IOException {
      left -= size;
      if (left < 0) {
        throw new IOException(text("archiveTooLarge", JobFiles.MAX_BYTES >> 20));
      }
    }
  }
}
