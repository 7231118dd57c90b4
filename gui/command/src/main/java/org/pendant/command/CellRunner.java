package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.protocols.ScriptConnectors;

/** Cell runner: {@code pendant run} of a scene in which several controllers work. */
final class CellRunner {
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
            CellPrograms.only(file, arguments));
    List<Optional<OutputFile>> records = new ArrayList<>();
    for (CellFile.Member member : members) {
      records.add(record(member));
    }
    members.stream().flatMap(each -> each.program().stream()).forEach(each -> each.tell(console));
    try (Interruption interruption = Interruption.listen("theRun");
        WallLimit wall = WallLimit.begin(options.wallTimeoutS(), file.name());
        ScriptConnectors connectors = new ScriptConnectors(options.hosts())) {
      List<ControllerOptions> switchedOn =
          members.stream()
              .map(each -> each.options().withOutside(connectors.connectors()))
              .toList();
      Optional<CellPrograms> loaded = CellPrograms.load(file, members, switchedOn, console);
      if (loaded.isEmpty()) {
        return ExitCode.DOES_NOT_COMPILE;
      }
      ExitCode code = run(loaded.get(), records, options, interruption, wall);
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      return code;
    }
  }

  private void refuse() throws UsageException {
    CellPrograms.refuse(file, arguments);
    if (arguments.has(OutputFile.FORCE) && arguments.value(RunOptions.RECORD).isEmpty()) {
      throw new UsageException(text("forceGoesWithRecord"));
    }
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

  private ExitCode run(
      CellPrograms programs,
      List<Optional<OutputFile>> records,
      RunOptions options,
      Interruption interruption,
      WallLimit wall)
      throws UsageException {
    List<RunRecord> opened = new ArrayList<>();
    interruption.hold();
    ExitCode code;
    try {
      for (int i = 0; i < records.size(); i++) {
        if (programs.members().get(i).program().isPresent()) {
          Cell.Member member = programs.cell().members().get(i);
          opened.add(
              RunRecord.open(records.get(i), RecordColumns.NONE, member.controller(), console));
        }
      }
      code =
          new CellRun(
                  programs.cell(),
                  programs.parts(opened, console),
                  options,
                  interruption,
                  wall,
                  console)
              .run();
    } finally {
      opened.forEach(RunRecord::close);
    }
    console.flush();
    interruption.release();
    return opened.stream().anyMatch(RunRecord::failed) ? code.or(ExitCode.WRONG_USAGE) : code;
  }
}
