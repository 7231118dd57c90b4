package org.pendant.command;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
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
  public String summary() {
    return "look for mistakes in programs, and for collisions in a scene";
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
    if (arguments.operands().isEmpty()) {
      throw new UsageException("no file given");
    }
    List<RunnableFile> files = RunnableFile.read(arguments);
    Optional<CellCheck> cell = CellCheck.of(arguments);
    InstallationOption.tell(arguments, console);
    Builtins<?> builtins = StandardBuiltins.create();
    ExitCode code = ExitCode.DONE;
    try (Interruption interruption = Interruption.listen("the check")) {
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
    }
    if (cell.isPresent()) {
      cell.get().write();
    }
    return code;
  }

  /** Checks a file of tests, which may call more than programs may. */
  private static ExitCode tests(String name, Arguments arguments, Console console) {
    TestFileReader reader =
        new TestFileReader(new TestFilesOnDisk(arguments), TestBuiltins.create(), false);
    try {
      reader.read(name).warnings().forEach(console::complain);
      return ExitCode.DONE;
    } catch (TestFileReader.Broken e) {
      e.file().problems().forEach(console::complain);
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
    loadResult.library().ifPresent(found -> console.complain(Report.note(source, found.message())));
    return loadResult.mistakes().stream().noneMatch(Diagnostic::isError);
  }
}
