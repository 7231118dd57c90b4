package org.pendant.sweep.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.run.SweepJob;

final class JobArchiveTest {
  @TempDir private Path folder;
  @TempDir private Path worker;
  private Path plan;

  @BeforeEach
  void writeFiles() throws IOException {
    write("cell/program/main.script", "def main():\n  x = 1\nend\n");
    write("cell/program/path.nc", "G1 X1\n");
    write("cell/arm.json", "{}");
    plan =
        write(
            "cell/plans/plan.toml",
            """
            program = "../program/main.script"
            [[parameter]]
            set = "variable x"
            values = [1, 2]
            """);
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private byte[] packed() throws Exception {
    return JobArchive.pack(plan, SweepJob.read(plan));
  }

  private List<String> filesOfWorker() throws IOException {
    try (Stream<Path> all = Files.walk(worker)) {
      return all.filter(Files::isRegularFile)
          .map(each -> worker.relativize(each).toString().replace('\\', '/'))
          .sorted()
          .toList();
    }
  }

  @Test
  void jobReadFromAnArchiveIsTheSameJob() throws Exception {
    SweepJob job = SweepJob.read(plan);

    Path unpacked = JobArchive.unpack(packed(), worker);

    SweepJob there = SweepJob.read(unpacked);
    assertEquals(job.identity(), there.identity());
    assertEquals(job.run(job.plan().variant(1)), there.run(there.plan().variant(1)));
  }

  @Test
  void archiveHasThePlanAndWhatLiesBesideTheProgram() throws Exception {
    JobArchive.unpack(packed(), worker);

    assertEquals(
        List.of("plans/plan.toml", "program/main.script", "program/path.nc"), filesOfWorker());
  }

  @Test
  void archiveHasNothingHiddenAndNoResults() throws Exception {
    write("cell/program/.git/config", "");
    write("cell/program/.secret", "");
    write("cell/program/elsewhere/results.csv", "run\n");
    write("cell/program/elsewhere/kept/0.rec", "");

    JobArchive.unpack(packed(), worker);

    assertEquals(
        List.of("plans/plan.toml", "program/main.script", "program/path.nc"), filesOfWorker());
  }

  @Test
  void fileThatIsNamedByItsWholePathIsRefused() throws Exception {
    Path program = folder.resolve("cell/program/main.script");
    Files.writeString(
        plan,
        "program = '" + program + "'\n[[parameter]]\nset = \"variable x\"\nvalues = [1, 2]\n");

    String told = assertThrows(PlanException.class, this::packed).getMessage();
    SweepJob job = SweepJob.read(plan);

    assertTrue(
        told.startsWith(plan + ": error: " + program + ": the plan names a file by its whole path"),
        told);
    assertEquals(
        told, assertThrows(PlanException.class, () -> JobArchive.check(plan, job)).getMessage());
  }

  @Test
  void folderWithThousandsOfFilesIsRefused() throws Exception {
    for (int i = 0; i < JobFiles.MAX_FILES; i++) {
      write("cell/program/many/" + i, "");
    }

    String told = assertThrows(PlanException.class, this::packed).getMessage();

    assertTrue(told.contains("more than 2000, or 256 MiB"), told);
  }

  @Test
  void archiveThatLeadsOutOfTheFolderIsRefused() throws Exception {
    for (String each : List.of("../other", "/tmp/other", "a/../../other", "folder/")) {
      byte[] archive = archive(each);
      assertThrows(IOException.class, () -> JobArchive.unpack(archive, worker), each);
    }
    assertEquals(List.of(), filesOfWorker());
  }

  @Test
  void whatIsNoArchiveIsRefused() {
    assertThrows(IOException.class, () -> JobArchive.unpack(new byte[0], worker));
    assertThrows(IOException.class, () -> JobArchive.unpack(new byte[] {1, 2, 3}, worker));
  }

  private static byte[] archive(String name) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry(name));
      zip.closeEntry();
    }
    return bytes.toByteArray();
  }
}
