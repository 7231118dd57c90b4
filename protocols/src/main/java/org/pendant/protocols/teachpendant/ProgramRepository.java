package org.pendant.protocols.teachpendant;

import static org.pendant.protocols.teachpendant.TeachPendantTexts.text;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.pendant.controller.Robot;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.installation.file.LoadedInstallation;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Program repository: the programs and installations of the programs folder. Any thread. */
final class ProgramRepository {
  private static final long MAX_BYTES = 32 << 20;
  private static final String SCRIPT = ".script";

  /** Programs that are listed: more are of no use. */
  static final int MAX_LISTED = 1000;

  private final ProgramsFolder folder;
  private final Robot robot;

  ProgramRepository(ProgramsFolder folder, Robot robot) {
    this.folder = folder;
    this.robot = robot;
  }

  /**
   * Reads and compiles a program.
   *
   * @param bytes name of a {@code .script}, {@code .urp}, {@code .pendant} or {@code .urpx} file,
   *     one {@code char} a byte: relative to the folder, below {@code /programs/}, or with the
   *     folder's own path
   */
  LoadedProgram load(String bytes) throws LoadTrouble {
    String name = inside(bytes);
    if (TreeFile.hasEnding(name)) {
      return tree(name);
    }
    if (!name.toLowerCase(Locale.ROOT).endsWith(SCRIPT)) {
      throw new LoadTrouble(
          true,
          text(
              "programOfOtherKind",
              bytes,
              TreeFile.ENDINGS.getFirst(),
              TreeFile.ENDINGS.getLast()));
    }
    Program program = compiled(Source.of(lastPart(name), read(name, SCRIPT)));
    return loaded(name, Optional.of(program), "", Optional.empty(), Optional.empty());
  }

  /**
   * The programs that stand in the folder itself, at most {@link #MAX_LISTED}, by name.
   *
   * @throws IOException if the folder cannot be read
   */
  List<ProgramFile> programs() throws IOException {
    if (folder.folder().isEmpty()) {
      return List.of();
    }
    List<Path> found;
    try (Stream<Path> files = Files.list(folder.folder().get())) {
      found =
          files
              .filter(each -> ProgramFile.isProgram(each.getFileName().toString()))
              .filter(Files::isRegularFile)
              .limit(MAX_LISTED)
              .toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    List<ProgramFile> programs = new ArrayList<>();
    for (Path each : found) {
      BasicFileAttributes facts = Files.readAttributes(each, BasicFileAttributes.class);
      programs.add(
          new ProgramFile(
              each.getFileName().toString(),
              facts.creationTime().toInstant(),
              facts.lastModifiedTime().toInstant()));
    }
    programs.sort(ProgramFile.ORDER);
    return programs;
  }

  private LoadedProgram tree(String name) throws LoadTrouble {
    TreeFile bare;
    try {
      String ending = name.substring(name.lastIndexOf('.')).toLowerCase(Locale.ROOT);
      bare = TreeFile.read(ByteText.decoded(name), read(name, ending));
    } catch (BrokenTree e) {
      throw new LoadTrouble(false, e.getMessage());
    }
    String wanted = bare.tree().installation();
    Optional<Installation> own = installationOf(name, wanted);
    TreeFile tree = bare.in(own.orElse(robot.installation()));
    Optional<byte[]> saved = tree.hasGaps() ? scriptBeside(name) : Optional.empty();
    if (saved.isPresent()) {
      Program program = compiled(Source.of(lastPart(name) + SCRIPT, saved.get()));
      return loaded(name, Optional.of(program), wanted, own, Optional.empty());
    }
    return loaded(
        name, generated(name, tree), wanted, own.map(_ -> tree.installation()), Optional.of(tree));
  }

  /** The program of a tree; empty while a part of it is missing. */
  private Optional<Program> generated(String name, TreeFile tree) throws LoadTrouble {
    List<String> problems = tree.problems();
    if (!problems.isEmpty()) {
      int others = problems.size() - 1;
      throw new LoadTrouble(
          false,
          others > 0 ? text("problemAndMore", problems.getFirst(), others) : problems.getFirst());
    }
    return tree.waitingNodes() > 0
        ? Optional.empty()
        : Optional.of(compiled(Source.of(lastPart(name) + SCRIPT, tree.script().text())));
  }

  /**
   * Compiles a program for one run.
   *
   * @param sent what its External Control nodes do
   */
  DrivenProgram driven(LoadedProgram program, ControlScript sent) throws LoadTrouble {
    TreeFile tree = program.tree().orElseThrow().with(sent);
    GeneratedScript script = tree.script();
    Program compiled =
        compiled(
            Source.of(program.name() + SCRIPT, script.text()),
            line -> tree.receivedAt(script, line).map(place -> place + ": ").orElse(""));
    return new DrivenProgram(compiled, tree, script);
  }

  /** A program as it is in the controller's present installation; scripts do not depend on it. */
  LoadedProgram renewed(LoadedProgram program) throws LoadTrouble {
    if (program.tree().isEmpty()) {
      return program;
    }
    TreeFile tree = program.tree().get().in(robot.installation());
    return new LoadedProgram(
        program.name(),
        program.path(),
        generated(program.name(), tree),
        program.installation(),
        program.setup(),
        Optional.of(tree),
        program.saved());
  }

  /** The installation that a program names, if it is there. */
  private Optional<Installation> installationOf(String program, String wanted) throws LoadTrouble {
    if (wanted.isEmpty()) {
      return Optional.empty();
    }
    String folderOfProgram = program.substring(0, program.lastIndexOf('/') + 1);
    for (String each : InstallationFile.namesOf(wanted)) {
      try {
        return Optional.of(
            installation(within(folderOfProgram + ByteText.asBytes(each))).installation());
      } catch (LoadTrouble e) {
        if (!e.missing()) {
          throw e;
        }
      }
    }
    return Optional.empty();
  }

  /** Takes out the steps up in a path that come back down again. */
  private static String within(String path) {
    Deque<String> steps = new ArrayDeque<>();
    for (String step : List.of(path.split("/", -1))) {
      if (step.equals("..") && !steps.isEmpty() && !steps.peekLast().equals("..")) {
        steps.removeLast();
      } else if (!step.equals(".")) {
        steps.addLast(step);
      }
    }
    return String.join("/", steps);
  }

  /** The script that PolyScope has saved beside a program. */
  private Optional<byte[]> scriptBeside(String name) throws LoadTrouble {
    try {
      return Optional.of(read(name.substring(0, name.lastIndexOf('.')) + SCRIPT, SCRIPT));
    } catch (LoadTrouble e) {
      if (e.missing()) {
        return Optional.empty();
      }
      throw e;
    }
  }

  private Program compiled(Source source) throws LoadTrouble {
    return compiled(source, _ -> "");
  }

  /**
   * @param before what is said of a line before what is wrong with it
   */
  private Program compiled(Source source, IntFunction<String> before) throws LoadTrouble {
    LoadResult loadResult = robot.load(source);
    if (loadResult.program().isEmpty()) {
      String why =
          loadResult.diagnostics().stream()
              .filter(Diagnostic::isError)
              .findFirst()
              .map(
                  each ->
                      before.apply(source.line(each.range().start()))
                          + firstLine(DiagnosticFormat.format(source, each)))
              .orElse(text("itDoesNotCompile"));
      throw new LoadTrouble(false, why);
    }
    if (loadResult.program().get().secondary()) {
      throw new LoadTrouble(false, text("secondaryProgram", source.name()));
    }
    return loadResult.program().get();
  }

  private static LoadedProgram loaded(
      String name,
      Optional<Program> program,
      String installation,
      Optional<Installation> setup,
      Optional<TreeFile> tree) {
    return new LoadedProgram(
        lastPart(name), ProgramsFolder.ROOT + name, program, installation, setup, tree, true);
  }

  /** The name of a file below the folder, however it was written. */
  String nameOf(String bytes) {
    return inside(bytes);
  }

  /**
   * Reads an installation.
   *
   * @param bytes name of its file, as for {@link #load}
   */
  LoadedInstallation installation(String bytes) throws LoadTrouble {
    String name = inside(bytes);
    String lower = name.toLowerCase(Locale.ROOT);
    Optional<String> ending = InstallationFile.ENDINGS.stream().filter(lower::endsWith).findFirst();
    if (ending.isEmpty()) {
      throw new LoadTrouble(
          true,
          text(
              "installationOfOtherKind",
              bytes,
              InstallationFile.ENDINGS.getFirst(),
              InstallationFile.ENDINGS.getLast()));
    }
    try {
      return InstallationFile.read(name, read(name, ending.get()), variables(name));
    } catch (InstallationTrouble e) {
      throw new LoadTrouble(false, e.getMessage());
    }
  }

  /** The values of an installation's variables, if they stand in a file beside it. */
  private Optional<byte[]> variables(String installation) throws LoadTrouble {
    Optional<String> name = InstallationFile.variablesOf(installation);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    String ending = name.get().substring(name.get().lastIndexOf('.'));
    try {
      return Optional.of(read(name.get(), ending));
    } catch (LoadTrouble e) {
      if (e.missing()) {
        return Optional.empty();
      }
      throw e;
    }
  }

  private byte[] read(String name, String ending) throws LoadTrouble {
    ProgramsFolder.Found found;
    try {
      found = folder.find(name, ending, MAX_BYTES);
    } catch (ScriptError e) {
      throw new LoadTrouble(true, e.getMessage());
    }
    try {
      return found.read();
    } catch (ScriptError e) {
      throw new LoadTrouble(false, e.getMessage());
    }
  }

  /** The name below the folder, however it was written. */
  private String inside(String bytes) {
    String name = bytes.strip();
    if (name.startsWith(ProgramsFolder.ROOT)) {
      return name.substring(ProgramsFolder.ROOT.length());
    }
    String own = folder.folder().map(ProgramRepository::asBytes).orElse("");
    return !own.isEmpty() && name.startsWith(own) ? name.substring(own.length()) : name;
  }

  private static String asBytes(Path path) {
    return ByteText.asBytes(path.toAbsolutePath() + "/");
  }

  private static String lastPart(String name) {
    return name.substring(name.lastIndexOf('/') + 1);
  }

  private static String firstLine(String text) {
    return text.lines().findFirst().orElse("");
  }
}
