package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.builtin.ArmlessBuiltins;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.testing.builtin.TestBuiltins;
import org.pendant.testing.builtin.TestCatalogue;
import org.pendant.testing.source.TestFileReader;

/**
 * Command {@code pendant check FILE...}: finds mistakes without running anything, and collisions by
 * running programs where nothing moves.
 */
final class CheckCommand implements Subcommand {

  @Override
  public String name() {
    return "check";
  }

  @Override
  public String operands() {
    return "FILE...";
  }

  @Override
  public List<Option> options() {
    return Stream.concat(
            Stream.of(CellCheck.CELL, CellCheck.JSON, OutputFile.FORCE),
            RunOptions.OF_CHECK.stream())
        .toList();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    List<String> names = arguments.operands();
    List<RunnableFile> files =
        RunnableFile.read(arguments, names.stream().filter(each -> !isScene(each)).toList());
    List<CellFile> scenes = new ArrayList<>();
    for (String name : names) {
      if (isScene(name)) {
        scenes.add(CellFile.read(name, arguments.files()));
      }
    }
    Optional<CellCheck> cell = CellCheck.of(arguments);
    Optional<SharedCellCheck> shared = cell.flatMap(CellCheck::shared);
    if (names.isEmpty() && shared.isEmpty()) {
      throw new UsageException(text("noFileGiven"));
    }
    InstallationOption.tell(arguments, console);
    Builtins<?> builtins = StandardBuiltins.create();
    ExitCode code;
    try (Interruption interruption = Interruption.listen("theCheck")) {
      code =
          shared.isPresent()
              ? shared.get().run(interruption, console)
              : check(files, cell, builtins, arguments, interruption, console);
    }
    if (cell.isPresent()) {
      cell.get().write();
    }
    for (CellFile scene : scenes) {
      code = code.or(programs(scene, arguments, builtins, console));
    }
    return code;
  }

  /** Checks files one after the other. */
  private static ExitCode check(
      List<RunnableFile> files,
      Optional<CellCheck> cell,
      Builtins<?> builtins,
      Arguments arguments,
      Interruption interruption,
      Console console)
      throws UsageException {
    ExitCode code = ExitCode.DONE;
    for (RunnableFile file : files) {
      file.tell(console);
      if (TestCatalogue.isFor(file.file())) {
        code = code.or(tests(file.file(), arguments, console));
      } else if (file.source().isEmpty() || !compiles(file, builtins, console)) {
        code = code.or(ExitCode.DOES_NOT_COMPILE);
      } else if (cell.isPresent() && !file.waits()) {
        code = code.or(cell.get().run(file, interruption, console));
      }
      if (interruption.requested()) {
        break;
      }
    }
    return code;
  }

  private static boolean isScene(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".json");
  }

  /** Checks the programs that a scene names: that of the cell may call less than others. */
  private static ExitCode programs(
      CellFile scene, Arguments arguments, Builtins<?> builtins, Console console)
      throws UsageException {
    ExitCode code = ExitCode.DONE;
    for (RunnableFile file : scene.programs(arguments)) {
      file.tell(console);
      boolean ofCell = scene.script().filter(file.file()::equals).isPresent();
      if (file.source().isEmpty()
          || !compiles(file, ofCell ? ArmlessBuiltins.create() : builtins, console)) {
        code = code.or(ExitCode.DOES_NOT_COMPILE);
      }
    }
    return code;
  }

  /** Checks a file of tests, which may call more than programs may. */
  private static ExitCode tests(String name, Arguments arguments, Console console) {
    TestFileReader reader =
        new TestFileReader(new TestFilesOnDisk(arguments), TestBuiltins.create(), false);
    try {
      reader.read(name).warnings().forEach(console::complainFromEnglish);
      return ExitCode.DONE;
    } catch (TestFileReader.Broken e) {
      e.file().problems().forEach(console::complainFromEnglish);
      return ExitCode.DOES_NOT_COMPILE;
    }
  }

  private static boolean compiles(RunnableFile file, Builtins<?> builtins, Console console) {
    if (file.waits()) {
      // what shows of it without the part that a driver sends has been told
      return true;
    }
    Source source = file.source().orElseThrow();
    LoadResult loadResult = ProgramLoader.load(source, builtins);
    Report.diagnostics(source, loadResult.mistakes()).forEach(console::complainInLines);
    loadResult
        .library()
        .ifPresent(
            found -> console.complain(Report.note(source, CommandLanguage.shown(found.message()))));
    return loadResult.mistakes().stream().noneMatch(Diagnostic::isError);
  }
}
