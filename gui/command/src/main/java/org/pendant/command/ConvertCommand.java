package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.models.arm.ArmDescription;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.installation.file.LoadedInstallation;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.urp.UrpPrograms;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingExport;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackRecording;

/**
 * Command {@code pendant convert FROM TO}: writes a file in another form; the endings say which.
 */
final class ConvertCommand implements Subcommand {
  private static final String SCRIPT = ".script";
  private static final String RECORDING = ".rec";
  private static final String GOLDEN = ".golden";
  private static final String TABLE = ".csv";
  private static final String POSSIBLE =
      ".urp, .urpx and .pendant become .pendant, .urp or .script, .installation becomes "
          + InstallationText.ENDING
          + ", .rec becomes .csv, .golden becomes .rec";

  /** What comes out, or why nothing does. */
  private record Result(ExitCode code, Optional<AtomicFile.Content> output) {
    static Result of(byte[] bytes) {
      return new Result(ExitCode.DONE, Optional.of(out -> out.write(bytes)));
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
  public List<Option> options() {
    return List.of(OutputFile.FORCE, InstallationOption.OPTION, RunOptions.ROBOT);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().size() != 2) {
      throw new UsageException(text("fromAndToExpected", arguments.operands().size()));
    }
    String from = arguments.operands().get(0);
    String to = arguments.operands().get(1);
    Result result = convert(from, to, arguments, console);
    OutputFile target = OutputFile.at(to, arguments);
    if (result.output().isPresent()) {
      target.write(result.output().get());
    }
    return result.code();
  }

  private static Result convert(String from, String to, Arguments arguments, Console console)
      throws UsageException {
    if (TreeFile.hasEnding(from) && (TreeFile.isWritable(to) || ends(to, SCRIPT))) {
      return program(from, to, arguments, console);
    }
    if (InstallationFile.hasEnding(from) && ends(to, InstallationText.ENDING)) {
      return installation(from, arguments.files(), console);
    }
    if (ends(from, RECORDING) && ends(to, TABLE)) {
      return recording(from, arguments.files(), console);
    }
    if (ends(from, GOLDEN) && ends(to, RECORDING)) {
      RunTrack track = GoldenFileComparison.read(from, false, arguments.files());
      ArmDescription arm = RobotName.model(arguments);
      return new Result(ExitCode.DONE, Optional.of(out -> TrackRecording.write(track, arm, out)));
    }
    throw new UsageException(text("cannotBecome", from, to, POSSIBLE));
  }

  private static boolean ends(String name, String ending) {
    return name.toLowerCase(Locale.ROOT).endsWith(ending);
  }

  private static Result program(String from, String to, Arguments arguments, Console console)
      throws UsageException {
    TreeOfFile read;
    try {
      read =
          TreeOfFile.of(
              from,
              arguments.files().bytes(RunnableFile.PROGRAM, from),
              InstallationOption.of(arguments),
              arguments.files());
    } catch (BrokenTree e) {
      e.reports().forEach(console::complainFromEnglish);
      return Result.none(ExitCode.DOES_NOT_COMPILE);
    }
    InstallationOption.tell(arguments, console);
    read.notes().forEach(console::complainFromEnglish);
    TreeFile file = read.file();
    if (ends(to, ProgramText.ENDING)) {
      return Result.of(ProgramText.write(file.tree()));
    }
    if (ends(to, UrpPrograms.ENDING)) {
      return urp(file, to, console);
    }
    List<String> problems = file.problems();
    problems.forEach(console::complainFromEnglish);
    if (file.waitingNodes() > 0) {
      console.complain(text("externalControlLeftOut", to));
    }
    return problems.isEmpty()
        ? Result.of(file.script().text())
        : Result.none(ExitCode.DOES_NOT_COMPILE);
  }

  private static Result urp(TreeFile file, String to, Console console) {
    String name = file.programName();
    ProgramTree tree = file.tree();
    UrpPrograms.notes(name, tree, file.installation())
        .forEach(note -> console.complain(text("noteIn", to, CommandLanguage.shown(note))));
    return Result.of(UrpPrograms.write(name, tree, file.installation()));
  }

  private static Result installation(String from, SourceFiles files, Console console)
      throws UsageException {
    try {
      Optional<String> variables =
          InstallationFile.variablesOf(from).filter(each -> Files.isRegularFile(Path.of(each)));
      Optional<byte[]> values =
          variables.isPresent()
              ? Optional.of(files.bytes("theFileOfVariables", variables.get()))
              : Optional.empty();
      LoadedInstallation read =
          InstallationFile.read(from, files.bytes("theInstallation", from), values);
      read.remarks()
          .forEach(each -> console.complain(text("noteIn", from, CommandLanguage.shown(each))));
      return Result.of(InstallationText.write(read.installation()));
    } catch (InstallationTrouble e) {
      console.complainFromEnglish(e.getMessage());
      return Result.none(ExitCode.DOES_NOT_COMPILE);
    }
  }

  private static Result recording(String from, SourceFiles files, Console console)
      throws UsageException {
    RecordingFile.Opened opened = RecordedFile.open(from, files.path("theRecording", from));
    opened
        .warning()
        .ifPresent(each -> console.complain(text("warningIn", from, CommandLanguage.shown(each))));
    Recording all = opened.recording();
    return new Result(
        ExitCode.DONE,
        Optional.of(out -> RecordingExport.toCsv(all, all.firstS(), all.lastS(), out)));
  }
}
