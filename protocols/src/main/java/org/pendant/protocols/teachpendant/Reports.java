package org.pendant.protocols.teachpendant;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.pendant.controller.Robot;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.VisibleText;

/**
 * Reports: files with what there is to know about a box: its log, its state, the loaded program,
 * the log files of interpreter mode. Any thread; writes files, so it may take long.
 */
public final class Reports {
  private static final DateTimeFormatter STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss-SSS");

  /** No client can fill the disk by asking for reports: the oldest ones go. */
  private static final int MAX_REPORTS = 20;

  private static final String FLIGHT = "flightreport-";
  private static final String SUPPORT = "supportfile-";
  private static final String ZIP = ".zip";

  private final Robot robot;
  private final PendantSetup setup;
  private final Supplier<Optional<LoadedProgram>> loaded;

  Reports(Robot robot, PendantSetup setup, Supplier<Optional<LoadedProgram>> loaded) {
    this.robot = robot;
    this.setup = setup;
    this.loaded = loaded;
  }

  /** Writes the log of the controller to {@code log_history.txt} in the folder for logs. */
  public synchronized void saveLog() throws IOException {
    AtomicFile.write(setup.logs().resolve("log_history.txt"), log());
  }

  /** Writes a flight report into the folder for logs; answers its id. */
  public synchronized String flightReport() throws IOException {
    Path folder = Files.createDirectories(setup.logs().resolve("flightreports"));
    removeOldest(folder);
    String id = LocalDateTime.now(ZoneId.systemDefault()).format(STAMP);
    write(folder.resolve(FLIGHT + id + ZIP));
    return id;
  }

  /**
   * Writes a support file.
   *
   * @param directory bytes, one {@code char} a byte: a folder in the programs folder; empty for
   *     that itself
   * @return where it is
   * @throws IOException if there is no such folder, it has {@value #MAX_REPORTS} of them already,
   *     or it cannot be written
   */
  public synchronized Path supportFile(String directory) throws IOException {
    Path folder = folder(directory);
    if (reports(folder, SUPPORT).size() >= MAX_REPORTS) {
      throw new IOException(
          directory + " has " + MAX_REPORTS + " support files already, some must be removed first");
    }
    Path file =
        folder.resolve(SUPPORT + LocalDateTime.now(ZoneId.systemDefault()).format(STAMP) + ZIP);
    write(file);
    return file;
  }

  private Path folder(String directory) throws IOException {
    if (setup.programs().folder().isEmpty()) {
      throw new IOException("there is no programs folder");
    }
    String name =
        new String(directory.strip().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    try {
      Path root = setup.programs().folder().get().toRealPath();
      String below =
          (name + "/").startsWith(ProgramsFolder.ROOT)
              ? (name + "/").substring(ProgramsFolder.ROOT.length())
              : name;
      Path folder = root.resolve(below).toRealPath();
      if (folder.startsWith(root) && Files.isDirectory(folder)) {
        return folder;
      }
    } catch (IOException | InvalidPathException e) {
      throw new IOException(name + " is no folder in the programs folder", e);
    }
    throw new IOException(name + " is no folder in the programs folder");
  }

  private static void removeOldest(Path folder) throws IOException {
    List<Path> present = reports(folder, FLIGHT);
    for (int i = 0; i <= present.size() - MAX_REPORTS; i++) {
      Files.delete(present.get(i));
    }
  }

  /** The reports of a kind in a folder, oldest first. */
  private static List<Path> reports(Path folder, String begin) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(each -> each.getFileName().toString().startsWith(begin))
          .filter(each -> each.getFileName().toString().endsWith(ZIP))
          .sorted()
          .toList();
    }
  }

  private void write(Path file) throws IOException {
    AtomicFile.write(file, this::write);
  }

  private void write(OutputStream out) throws IOException {
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      put(zip, "version.txt", SoftwareVersion.REPORTED.text().getBytes(StandardCharsets.UTF_8));
      put(zip, "log_history.txt", log());
      put(zip, "state.txt", robot.state().toString().getBytes(StandardCharsets.UTF_8));
      Optional<LoadedProgram> program = loaded.get();
      if (program.isPresent()) {
        put(zip, "program/" + program.get().name(), text(program.get()));
      }
      for (Path each : interpreterLogs()) {
        put(zip, "urcontrol/" + each.getFileName(), Files.readAllBytes(each));
      }
    }
  }

  private static byte[] text(LoadedProgram program) {
    return program
        .program()
        .map(each -> each.source().bytes())
        .or(() -> program.tree().map(each -> each.script().text().getBytes(StandardCharsets.UTF_8)))
        .orElse(new byte[0]);
  }

  private List<Path> interpreterLogs() {
    List<Path> found = new ArrayList<>();
    for (String name : InterpreterFiles.NAMES) {
      Path file = setup.logs().resolve(name);
      if (Files.isRegularFile(file)) {
        found.add(file);
      }
    }
    return found;
  }

  private static void put(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
    zip.putNextEntry(new ZipEntry(name));
    zip.write(bytes);
    zip.closeEntry();
  }

  private byte[] log() {
    StringBuilder text = new StringBuilder();
    for (LogEntry each : robot.logSince(0)) {
      text.append(String.format(Locale.ROOT, "%.3f", each.timeS()))
          .append(' ')
          .append(each.level())
          .append(' ')
          .append(each.code().isEmpty() ? "-" : each.code())
          .append(' ')
          .append(VisibleText.message(ByteText.decoded(each.text())))
          .append('\n');
    }
    return text.toString().getBytes(StandardCharsets.UTF_8);
  }
}
