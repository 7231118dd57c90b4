package org.pendant.spark;

import static org.pendant.spark.SparkTexts.text;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.remote.JobArchive;
import org.pendant.sweep.run.SweepJob;

/**
 * Worker job: the job of a sweep as it goes to workers. Each process of workers reads its files
 * once, when it runs the first variant.
 */
final class WorkerJob implements Serializable {
  private static final long serialVersionUID = 1L;

  private final byte[] archive;
  private final String identity;
  private transient SweepJob job;

  /**
   * @param archive of {@link JobArchive}
   * @param identity of the job that was packed
   */
  WorkerJob(byte[] archive, String identity) {
    this.archive = archive;
    this.identity = identity;
  }

  /**
   * The job, read.
   *
   * @throws IOException if its files cannot be written, or are not those of the driver
   */
  synchronized SweepJob job() throws IOException {
    if (job == null) {
      Path folder = Files.createTempDirectory("pendant-sweep");
      // programs open files in it while they run
      Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder), "pendant-sweep"));
      job = read(folder);
    }
    return job;
  }

  private SweepJob read(Path folder) throws IOException {
    try {
      SweepJob read = SweepJob.read(JobArchive.unpack(archive, folder));
      if (!read.identity().equals(identity)) {
        throw new IOException(text("otherFilesAtTheWorker"));
      }
      return read;
    } catch (PlanException e) {
      throw new IOException(String.join("; ", e.reports()), e);
    }
  }

  private static void delete(Path folder) {
    try {
      Files.walkFileTree(
          folder,
          new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
                throws IOException {
              Files.delete(file);
              return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path dir, IOException failure)
                throws IOException {
              Files.delete(dir);
              return FileVisitResult.CONTINUE;
            }
          });
    } catch (IOException e) {
      throw new UncheckedIOException(folder + " stays", e);
    }
  }
}
