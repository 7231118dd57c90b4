package org.pendant.command.doctor;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.pendant.command.service.StateFolder;

/**
 * Problem report: a file that people send with a report of a fault. It has what the {@link Doctor}
 * found, the faults that the window has noted and what the last crashes of the JVM were, without
 * names of the user, the home folder and the computer; no programs, settings or logs.
 */
public final class ProblemReport {
  private final Map<String, String> texts;

  private ProblemReport(Map<String, String> texts) {
    this.texts = texts;
  }

  /**
   * The report of this computer.
   *
   * @param findings what there is
   * @throws IOException if the faults or the logs of crashes cannot be read
   */
  public static ProblemReport of(List<Finding> findings) throws IOException {
    Map<String, String> environment = System.getenv();
    return of(
        findings,
        StateFolder.faults(environment),
        CrashLogs.folders(environment),
        PrivateNames.of(environment));
  }

  static ProblemReport of(
      List<Finding> findings, Path faults, List<Path> crashes, PrivateNames names)
      throws IOException {
    Map<String, String> texts = new LinkedHashMap<>();
    texts.put("doctor.txt", String.join("\n", Doctor.englishLines(findings)) + "\n");
    for (Path file : List.of(faults.resolveSibling("older-" + faults.getFileName()), faults)) {
      if (Files.exists(file)) {
        texts.put(file.getFileName().toString(), Files.readString(file));
      }
    }
    for (Path file : CrashLogs.newest(crashes)) {
      texts.put(file.getFileName().toString(), CrashLogs.excerpt(file));
    }
    texts.replaceAll((name, text) -> names.removedFrom(text));
    return new ProblemReport(texts);
  }

  /** The names of the files in it, for people. */
  public String contents() {
    return String.join(", ", texts.keySet());
  }

  /** Its files by name, as they are written. */
  Map<String, String> texts() {
    return texts;
  }

  /** Writes it as a zip file. */
  public void write(OutputStream out) throws IOException {
    ZipOutputStream zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
    for (Map.Entry<String, String> each : texts.entrySet()) {
      zip.putNextEntry(new ZipEntry(each.getKey()));
      zip.write(each.getValue().getBytes(StandardCharsets.UTF_8));
      zip.closeEntry();
    }
    zip.finish();
  }
}
