package org.pendant.gui.command;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.installation.file.InstallationFile;
import org.pendant.controller.installation.file.InstallationTrouble;
import org.pendant.controller.installation.file.LoadedInstallation;
import org.pendant.controller.installation.text.InstallationText;
import org.pendant.controller.program.ProgramTree;
import org.pendant.controller.program.file.BrokenTree;
import org.pendant.controller.program.file.TreeFile;
import org.pendant.controller.program.text.ProgramText;
import org.pendant.controller.program.urp.UrpPrograms;
import org.pendant.controller.recording.Recording;
import org.pendant.controller.recording.RecordingExport;
import org.pendant.controller.recording.RecordingFile;

/** {@code pendant convert FROM TO}: writes a file in another form; the endings say which. */
final class ConvertCommand implements Subcommand {
  private static final Option FORCE =
      new Option("--force", "", "replace TO if there is such a file already");

  private static final String SCRIPT = ".script";
  private static final String RECORDING = ".rec";
  private static final String TABLE = ".csv";
  private static final String POSSIBLE =
      ".urp and .pendant become .pendant, .urp or .script, .installation becomes "
          + InstallationText.ENDING
          + ", .rec becomes .csv";

  /** Writes what comes out to a file of its own. */
  @FunctionalInterface
  private interface Output {
    void write(Path file) throws IOException;
  }

  /** What comes out, or why nothing does. */
  private record Result(ExitCode code, Optional<Output> output) {
    static Result of(byte[] bytes) {
      return new Result(ExitCode.DONE, Optional.of(file -> write(file, bytes)));
    }

    private static void write(Path file, byte[] bytes) throws IOException {
      if (Files.exists(file)) {
        AtomicFile.write(file, bytes);
      } else {
        Files.write(file, bytes, StandardOpenOption.CREATE_NEW);
      }
    }

    static Result of(String text) {
      return of(text.getBytes(StandardCharsets.UTF_8));
    }

    static Result none(ExitCode code) {
      return new Result(code, Optional.empty());
    }
  }

  @Override
  public String name() {
    return "convert";
  }

  @Override
  public String operands() {
    return "FROM TO";
  }

  @Override
  public String summary() {
    return "write a program, installation or recording in another form";
  }

  @Override
  public List<Option> options() {
    return List.of(FORCE, InstallationOption.OPTION);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().size() != 2) {
      throw new UsageException(
          "expected two files, FROM and TO, there are " + arguments.operands().size());
    }
    String from = arguments.operands().get(0);
    String to = arguments.operands().get(1);
    boolean force = arguments.has(FORCE);
    Path target = target(to, force);
    Result result = convert(from, to, arguments, console);
    if (result.output().isPresent()) {
      write(result.output().get(), target, to);
    }
    return result.code();
  }

  /** The file is looked at first: nobody wants to wait for a refusal. */
  private static Path target(String to, boolean force) throws UsageException {
    try {
      Path target = Path.of(to).toAbsolutePath();
      if (Files.isDirectory(target)) {
        throw new UsageException(to + " is a directory");
      }
      if (Files.exists(target) && !force) {
        throw new UsageException(to + " exists already, --force replaces it");
      }
      return target;
    } catch (InvalidPathException e) {
      throw new UsageException(to + ": not a file name, " + e.getReason());
    }
  }

  private static Result convert(String from, String to, Arguments arguments, Console console)
      throws UsageException {
    if (TreeFile.hasEnding(from) && (TreeFile.hasEnding(to) || ends(to, SCRIPT))) {
      return program(from, to, arguments, console);
    }
    if (InstallationFile.hasEnding(from) && ends(to, InstallationText.ENDING)) {
      return installation(from, console);
    }
    if (ends(from, RECORDING) && ends(to, TABLE)) {
      return recording(from, console);
    }
    throw new UsageException(from + " cannot become " + to + ": " + POSSIBLE);
  }

  private static boolean ends(String name, String ending) {
    return name.toLowerCase(Locale.ROOT).endsWith(ending);
  }

  private static Result program(String from, String to, Arguments arguments, Console console)
      throws UsageException {
    TreeOfFile read;
    try {
      read = TreeOfFile.of(from, SourceFiles.bytes(from), InstallationOption.of(arguments));
    } catch (BrokenTree e) {
      e.reports().forEach(console::complain);
      return Result.none(ExitCode.DOES_NOT_COMPILE);
    }
    read.notes().forEach(console::complain);
    TreeFile file = read.file();
    if (ends(to, ProgramText.ENDING)) {
      return Result.of(ProgramText.write(file.tree()));
    }
    if (ends(to, UrpPrograms.ENDING)) {
      return urp(file, to, console);
    }
    List<String> problems = file.problems();
    problems.forEach(console::complain);
    return problems.isEmpty()
        ? Result.of(file.script().text())
        : Result.none(ExitCode.DOES_NOT_COMPILE);
  }

  private static Result urp(TreeFile file, String to, Console console) {
    String name = file.programName();
    ProgramTree tree = file.tree();
    console.complain(
        to
            + ": note: writing .urp is experimental, as its form is not published; no robot has"
            + " loaded such a file yet");
    for (String own : UrpPrograms.ownForms(name, tree, file.installation())) {
      console.complain(
          to + ": note: " + own + " is written in a form of Pendant's own, which no robot knows");
    }
    return Result.of(UrpPrograms.write(name, tree, file.installation()));
  }

  private static Result installation(String from, Console console) throws UsageException {
    try {
      Optional<String> variables =
          InstallationFile.variablesOf(from).filter(each -> Files.isRegularFile(Path.of(each)));
      Optional<byte[]> values =
          variables.isPresent()
              ? Optional.of(SourceFiles.bytes(variables.get()))
              : Optional.empty();
      LoadedInstallation read = InstallationFile.read(from, SourceFiles.bytes(from), values);
      read.remarks().forEach(each -> console.complain(from + ": note: " + each));
      return Result.of(InstallationText.write(read.installation()));
    } catch (InstallationTrouble e) {
      console.complain(e.getMessage());
      return Result.none(ExitCode.DOES_NOT_COMPILE);
    }
  }

  private static Result recording(String from, Console console) throws UsageException {
    try {
      RecordingFile.Opened opened = RecordingFile.open(Path.of(from));
      opened.warning().ifPresent(each -> console.complain(from + ": warning: " + each));
      Recording all = opened.recording();
      return new Result(
          ExitCode.DONE,
          Optional.of(file -> RecordingExport.toCsv(all, all.firstS(), all.lastS(), file)));
    } catch (IOException e) {
      throw new UsageException(from + ": " + FileTrouble.reason(e));
    } catch (InvalidPathException e) {
      throw new UsageException(from + ": not a file name, " + e.getReason());
    }
  }

  private static void write(Output output, Path target, String to) throws UsageException {
    try {
      output.write(target);
    } catch (IOException e) {
      throw new UsageException(to + ": cannot be written, " + FileTrouble.reason(e));
    }
  }
}
