package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonException;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Cell runner: {@code pendant run} of a scene in which several controllers work. */
final class CellRunner {
  private static final List<Option> OF_ONE =
      List.of(
          LineReport.OPTION,
          RecordColumns.OPTION,
          ToolSerialOption.OPTION,
          SimulationOptions.DEVICE,
          InstallationOption.OPTION);

  private final CellFile file;
  private final Arguments arguments;
  private final Console console;

  CellRunner(CellFile file, Arguments arguments, Console console) {
    this.file = file;
    this.arguments = arguments;
    this.console = console;
  }

  /** Runs all programs. */
  ExitCode run() throws UsageException {
    refuse();
    RunOptions options = RunOptions.of(arguments);
    List<CellFile.Member> members =
        file.members(
            arguments,
            (installation, robot) -> RunOptions.of(arguments, installation, robot).controller(),
            only());
    List<Optional<OutputFile>> records = new ArrayList<>();
    for (CellFile.Member member : members) {
      records.add(record(member));
    }
    members.stream().flatMap(each -> each.program().stream()).forEach(each -> each.tell(console));
    try (Interruption interruption = Interruption.listen("the run");
        WallLimit wall = WallLimit.begin(options.wallTimeoutS(), file.name());
        ScriptConnectors connectors = new ScriptConnectors(options.hosts())) {
      List<ControllerOptions> switchedOn =
          members.stream()
              .map(each -> each.options().withOutside(connectors.connectors()))
              .toList();
      Cell cell = cell(switchedOn);
      Optional<List<Program>> programs = programs(members, cell);
      if (programs.isEmpty()) {
        return ExitCode.DOES_NOT_COMPILE;
      }
      ExitCode code = run(members, cell, programs.get(), records, options, interruption, wall);
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      return code;
    }
  }

  private Cell cell(List<ControllerOptions> options) throws UsageException {
    try {
      return new Cell(file.plan(), options, StandardBuiltins.create());
    } catch (JsonException e) {
      throw new UsageException(e.getMessage());
    }
  }

  private void refuse() throws UsageException {
    for (Option option : OF_ONE) {
      if (arguments.has(option)) {
        throw new UsageException(
            option.name() + " goes with one controller, " + file.name() + " has several");
      }
    }
    if (arguments.has(OutputFile.FORCE) && arguments.value(RunOptions.RECORD).isEmpty()) {
      throw new UsageException("--force goes with --record, which is missing");
    }
  }

  /** The program on the command line, which is that of the only arm. */
  private Optional<RunnableFile> only() throws UsageException {
    List<String> operands = arguments.operands();
    if (!file.plan().layout().arms().isEmpty()) {
      if (!operands.isEmpty()) {
        throw new UsageException(
            file.name()
                + " has arms with programs of their own, but there is also "
                + operands.getFirst());
      }
      if (file.plan().layout().arms().stream().allMatch(arm -> arm.program().isEmpty())) {
        throw new UsageException(file.name() + " has arms, but names no program of one");
      }
      return Optional.empty();
    }
    if (operands.size() != 1) {
      throw new UsageException(
          operands.isEmpty()
              ? "no file given"
              : file.name() + " has a script of the cell, which goes with one program");
    }
    return Optional.of(RunnableFile.read(arguments).getFirst());
  }

  /** A record for each arm: its name stands before the ending. */
  private Optional<OutputFile> record(CellFile.Member member) throws UsageException {
    Optional<String> name = arguments.value(RunOptions.RECORD);
    if (name.isEmpty() || member.program().isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        OutputFile.of(RunOptions.RECORD, named(name.get(), member.name()), arguments));
  }

  /** The file of one controller among those of all. */
  static String named(String file, String member) {
    int folder = Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\'));
    int ending = file.lastIndexOf('.');
    return ending > folder + 1
        ? file.substring(0, ending) + "." + member + file.substring(ending)
        : file + "." + member;
  }

  /** Compiles all programs and says what is wrong with each; empty if one does not compile. */
  private Optional<List<Program>> programs(List<CellFile.Member> members, Cell cell) {
    List<Program> programs = new ArrayList<>();
    boolean right = true;
    for (int i = 0; i < members.size(); i++) {
      Optional<RunnableFile> file = members.get(i).program();
      if (file.isPresent()) {
        Optional<Program> program = program(file.get(), cell.members().get(i));
        program.ifPresent(programs::add);
        right &= program.isPresent();
      }
    }
    return right ? Optional.of(programs) : Optional.empty();
  }

  private Optional<Program> program(RunnableFile file, Cell.Member member) {
    if (file.source().isEmpty()) {
      return Optional.empty();
    }
    Source source = file.source().get();
    LoadResult result = member.controller().load(source);
    Report.diagnostics(source, result.diagnostics()).forEach(console::complainInLines);
    Optional<Program> program = result.program();
    if (program.isPresent() && program.get().secondary()) {
      console.complain(
          Report.error(source, "is a secondary program, " + member.name() + " must run a primary"));
      return Optional.empty();
    }
    return program;
  }

  private ExitCode run(
      List<CellFile.Member> members,
      Cell cell,
      List<Program> programs,
      List<Optional<OutputFile>> records,
      RunOptions options,
      Interruption interruption,
      WallLimit wall)
      throws UsageException {
    List<CellRun.Part> parts = new ArrayList<>();
    List<RunRecord> opened = new ArrayList<>();
    interruption.hold();
    ExitCode code;
    try {
      for (int i = 0; i < members.size(); i++) {
        Cell.Member member = cell.members().get(i);
        if (members.get(i).program().isPresent()) {
          RunRecord record =
              RunRecord.open(records.get(i), RecordColumns.NONE, member.controller(), console);
          opened.add(record);
          parts.add(
              new CellRun.Part(
                  member,
                  new ProgramReport(
                      members.get(i).program().get(),
                      member.controller(),
                      console,
                      member.name() + ": "),
                  programs.get(parts.size()),
                  record));
        }
      }
      code = new CellRun(cell, parts, options, interruption, wall, console).run();
    } finally {
      opened.forEach(RunRecord::close);
    }
    console.flush();
    interruption.release();
    return opened.stream().anyMatch(RunRecord::failed) ? code.or(ExitCode.WRONG_USAGE) : code;
  }
}
