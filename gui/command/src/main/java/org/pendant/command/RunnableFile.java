package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.urp.UrpPrograms;
import org.pendant.protocols.externalcontrol.Drivers;
import org.pendant.protocols.externalcontrol.NoScript;

/**
 * Runnable file: a program that a command line names: a script, or a tree together with the script
 * that is generated from it.
 *
 * @param file its name there
 * @param source what runs; empty for a tree that cannot run
 * @param tree the tree, if it is one and runs as such
 * @param installation the one that the program itself names, if it is there and none was given
 * @param robot id of the arm that it was made on, if the file tells
 * @param notes what people should know
 * @param problems what keeps it from running, apart from mistakes in scripts
 */
record RunnableFile(
    String file,
    Optional<Source> source,
    Optional<TreeFile> tree,
    Optional<Installation> installation,
    Optional<String> robot,
    List<String> notes,
    List<String> problems) {

  /** What it is to a command. */
  static final String PROGRAM = "theProgram";

  private static final String SCRIPT = ".script";

  RunnableFile {
    notes = List.copyOf(notes);
    problems = List.copyOf(problems);
  }

  /**
   * Reads all programs that a command line names, before anything is done with the first: a slip in
   * the last name shows at once.
   *
   * @throws UsageException when a file cannot be read
   */
  static List<RunnableFile> read(Arguments arguments) throws UsageException {
    return read(arguments, arguments.operands());
  }

  /** As {@link #read(Arguments)}, of those operands that are programs. */
  static List<RunnableFile> read(Arguments arguments, List<String> names) throws UsageException {
    Optional<Installation> given = InstallationOption.of(arguments);
    SourceFiles files = arguments.files();
    List<RunnableFile> read = new ArrayList<>();
    for (String name : names) {
      byte[] bytes = files.bytes(PROGRAM, name);
      read.add(TreeFile.hasEnding(name) ? tree(name, bytes, given, files) : script(name, bytes));
    }
    return read;
  }

  private static RunnableFile script(String name, byte[] bytes) {
    return new RunnableFile(
        name,
        Optional.of(Source.of(name, bytes)),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        List.of(),
        List.of());
  }

  private static RunnableFile tree(
      String name, byte[] bytes, Optional<Installation> given, SourceFiles files)
      throws UsageException {
    TreeOfFile read;
    try {
      read = TreeOfFile.of(name, bytes, given, files);
    } catch (BrokenTree e) {
      return new RunnableFile(
          name,
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          List.of(),
          e.reports());
    }
    TreeFile tree = read.file();
    Optional<String> beside = tree.hasGaps() ? scriptBeside(name) : Optional.empty();
    if (beside.isPresent()) {
      List<String> notes = new ArrayList<>(read.notes());
      notes.add(text("savedScriptRuns", name, beside.get()));
      Source saved = Source.of(beside.get(), files.bytes("theScript", beside.get()));
      return new RunnableFile(
          name, Optional.of(saved), Optional.empty(), read.own(), tree.robot(), notes, List.of());
    }
    List<String> problems = tree.problems();
    Source generated = Source.of(tree.scriptName(), tree.script().text());
    return new RunnableFile(
        name,
        problems.isEmpty() ? Optional.of(generated) : Optional.empty(),
        Optional.of(tree),
        read.own(),
        tree.robot(),
        read.notes(),
        problems);
  }

  /** PolyScope saves with each program the script that it has become. */
  private static Optional<String> scriptBeside(String name) {
    if (!name.toLowerCase(Locale.ROOT).endsWith(UrpPrograms.ENDING)) {
      return Optional.empty();
    }
    String script = name.substring(0, name.length() - UrpPrograms.ENDING.length()) + SCRIPT;
    return Files.isRegularFile(Path.of(script)) ? Optional.of(script) : Optional.empty();
  }

  /** Says what is to be said before it runs. */
  void tell(Console console) {
    notes.forEach(console::complainFromEnglish);
    problems.forEach(console::complainFromEnglish);
  }

  /** Whether a driver must be asked for a part of it before it can run. */
  boolean waits() {
    return source.isPresent() && tree.filter(each -> each.waitingNodes() > 0).isPresent();
  }

  /**
   * The same with the part that a driver has to send; waits for that.
   *
   * @throws NoScript if it sends none
   */
  RunnableFile asked(Drivers drivers) throws NoScript {
    if (!waits()) {
      return this;
    }
    TreeFile waiting = tree.orElseThrow();
    try {
      TreeFile whole =
          waiting.with(
              drivers.request(waiting.installation(), waiting.waitingNodes()).begin().await());
      Source generated = Source.of(whole.scriptName(), whole.script().text());
      return new RunnableFile(
          file, Optional.of(generated), Optional.of(whole), installation, robot, notes, problems);
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts the thread that reads programs", e);
    }
  }

  /**
   * Which node a line of the script belongs to, and which line of what a driver has sent it is, as
   * the beginning of a line for people.
   */
  Optional<String> nodeAt(int line) {
    String places =
        tree.stream()
            .flatMap(
                each ->
                    Stream.of(each.nodeAt(line), each.receivedAt(each.script(), line))
                        .flatMap(Optional::stream))
            .collect(Collectors.joining(", "));
    return places.isEmpty() ? Optional.empty() : Optional.of(file + ": " + places + ": ");
  }

  /** What is wrong in what a driver has sent, each with its line there. */
  List<String> wrongInReceived(List<Diagnostic> diagnostics) {
    if (tree.isEmpty() || source.isEmpty()) {
      return List.of();
    }
    GeneratedScript script = tree.get().script();
    return diagnostics.stream()
        .filter(Diagnostic::isError)
        .flatMap(
            each ->
                tree
                    .get()
                    .receivedAt(script, source.get().line(each.range().start()))
                    .map(place -> file + ": " + place + ": " + ByteText.decoded(each.message()))
                    .stream())
        .toList();
  }
}
