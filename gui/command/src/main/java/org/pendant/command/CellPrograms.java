package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonException;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/**
 * Cell programs: the controllers of a cell, switched on, and what they run together.
 *
 * @param members as the file has them
 * @param cell with the same members, in their order
 * @param programs of those members that run something, in their order
 */
record CellPrograms(List<CellFile.Member> members, Cell cell, List<Program> programs) {
  private static final List<Option> OF_ONE =
      List.of(
          LineReport.OPTION,
          RecordColumns.OPTION,
          ToolSerialOption.OPTION,
          SimulationOptions.DEVICE,
          InstallationOption.OPTION);

  /**
   * Refuses options that are for one controller alone.
   *
   * @throws UsageException if the command line has one of them
   */
  static void refuse(CellFile file, Arguments arguments) throws UsageException {
    for (Option option : OF_ONE) {
      if (arguments.has(option)) {
        throw new UsageException(text("goesWithOneController", option.name(), file.name()));
      }
    }
  }

  /**
   * The program on the command line, which is that of the only arm; empty where the arms have
   * programs of their own.
   *
   * @throws UsageException if there is one too many or too few, or it cannot be read
   */
  static Optional<RunnableFile> only(CellFile file, Arguments arguments) throws UsageException {
    List<String> operands = arguments.operands();
    if (!file.plan().layout().arms().isEmpty()) {
      if (!operands.isEmpty()) {
        throw new UsageException(text("armsHavePrograms", file.name(), operands.getFirst()));
      }
      if (file.plan().layout().arms().stream().allMatch(arm -> arm.program().isEmpty())) {
        throw new UsageException(text("armsHaveNoProgram", file.name()));
      }
      return Optional.empty();
    }
    if (operands.size() != 1) {
      throw new UsageException(
          operands.isEmpty() ? text("noFileGiven") : text("scriptOfCell", file.name()));
    }
    return Optional.of(RunnableFile.read(arguments).getFirst());
  }

  /**
   * Switches the controllers on, compiles all programs and says what is wrong with each; empty if
   * one does not compile.
   *
   * @param options of each member
   * @throws UsageException if the cell cannot be as its file says
   */
  static Optional<CellPrograms> load(
      CellFile file,
      List<CellFile.Member> members,
      List<ControllerOptions> options,
      Console console)
      throws UsageException {
    Cell cell;
    try {
      cell = new Cell(file.plan(), options, StandardBuiltins.create());
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    }
    List<Program> programs = new ArrayList<>();
    boolean right = true;
    for (int i = 0; i < members.size(); i++) {
      Optional<RunnableFile> runs = members.get(i).program();
      if (runs.isPresent()) {
        Optional<Program> program = program(runs.get(), cell.members().get(i), console);
        program.ifPresent(programs::add);
        right &= program.isPresent();
      }
    }
    return right ? Optional.of(new CellPrograms(members, cell, programs)) : Optional.empty();
  }

  private static Optional<Program> program(RunnableFile file, Cell.Member member, Console console) {
    if (file.source().isEmpty()) {
      return Optional.empty();
    }
    Source source = file.source().get();
    LoadResult result = member.controller().load(source);
    Report.diagnostics(source, result.diagnostics()).forEach(console::complainInLines);
    Optional<Program> program = result.program();
    if (program.isPresent() && program.get().secondary()) {
      console.complain(Report.error(source, text("secondaryProgram", member.name())));
      return Optional.empty();
    }
    return program;
  }

  /**
   * What takes part in a run.
   *
   * @param watchers of those members that run something, in their order
   * @param console takes what programs say
   */
  List<CellRun.Part> parts(List<? extends FrameWatcher> watchers, Console console) {
    List<CellRun.Part> parts = new ArrayList<>();
    for (int i = 0; i < members.size(); i++) {
      Cell.Member member = cell.members().get(i);
      Optional<RunnableFile> file = members.get(i).program();
      if (file.isPresent()) {
        int number = parts.size();
        parts.add(
            new CellRun.Part(
                member,
                new ProgramReport(file.get(), member.controller(), console, member.name() + ": "),
                programs.get(number),
                watchers.get(number)));
      }
    }
    return parts;
  }
}
