package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Controller;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.external.Connectors;
import org.pendant.language.source.Source;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.protocols.toolserial.ToolSerialServer;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Command {@code pendant run FILE...}: runs programs, each in a controller of its own. */
final class RunCommand implements Subcommand {

  /**
   * What is written of a run.
   *
   * @param file the record; empty for none
   * @param profile what the lines took; empty for none
   */
  private boolean mayEndAtOnce;

  private record Recorded(
      Optional<OutputFile> file, RecordColumns columns, Optional<OutputFile> profile) {}

  @Override
  public String name() {
    return "run";
  }

  @Override
  public String operands() {
    return "FILE...";
  }

  @Override
  public List<Option> options() {
    return RunOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    RunOptions options = RunOptions.of(arguments);
    RecordColumns columns = RecordColumns.of(arguments, options.record());
    Optional<CellFile> cell = CellFile.of(arguments);
    if (cell.isPresent()) {
      return new CellRunner(cell.get(), arguments, console).run();
    }
    if (arguments.operands().isEmpty()) {
      throw new UsageException(text("noFileGiven"));
    }
    boolean profiled = arguments.has(LineReport.OPTION);
    if (options.record().isEmpty() && !profiled && arguments.has(OutputFile.FORCE)) {
      throw new UsageException(text("forceGoesWithRecordOrProfile"));
    }
    if ((options.record().isPresent() || profiled) && arguments.operands().size() > 1) {
      throw new UsageException(
          text("goesWithOneProgram", (profiled ? LineReport.OPTION : RunOptions.RECORD).name()));
    }
    List<RunnableFile> files = RunnableFile.read(arguments);
    Recorded recorded = recorded(arguments, columns);
    InstallationOption.tell(arguments, console);
    Builtins<ControlBox> builtins = StandardBuiltins.create();
    ExitCode code = ExitCode.DONE;
    try (Interruption interruption = Interruption.listen("theRun")) {
      for (RunnableFile file : files) {
        file.tell(console);
        RunOptions own =
            file.installation().isPresent() || file.robot().isPresent()
                ? RunOptions.of(arguments, file.installation(), file.robot())
                : options;
        try (WallLimit wall = WallLimit.begin(own.wallTimeoutS(), file.file())) {
          RunnableFile whole = file.asked(own.drivers());
          code = code.or(run(whole, own, recorded, builtins, interruption, wall, console));
        } catch (NoScript e) {
          console.complain(text("errorIn", file.file(), CommandLanguage.shown(e.getMessage())));
          code = code.or(ExitCode.UNAVAILABLE);
        }
        if (interruption.requested() || console.outputClosed()) {
          break;
        }
      }
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      // The library of serial devices leaves it to the exit to remove where it was unpacked.
      mayEndAtOnce = !interruption.requested() && options.toolDevice().isEmpty();
    }
    return code;
  }

  @Override
  public boolean mayEndAtOnce() {
    return mayEndAtOnce;
  }

  private static Recorded recorded(Arguments arguments, RecordColumns columns)
      throws UsageException {
    Optional<OutputFile> record = OutputFile.of(RunOptions.RECORD, arguments);
    Optional<OutputFile> profile = OutputFile.of(LineReport.OPTION, arguments);
    if (record.isPresent() && record.map(OutputFile::path).equals(profile.map(OutputFile::path))) {
      throw new UsageException(text("recordAndProfileSame"));
    }
    return new Recorded(record, columns, profile);
  }

  private static ExitCode run(
      RunnableFile file,
      RunOptions options,
      Recorded recorded,
      Builtins<ControlBox> builtins,
      Interruption interruption,
      WallLimit wall,
      Console console)
      throws UsageException {
    // closed last: what a program has sent on its last line still goes out
    try (ScriptConnectors scriptConnectors = new ScriptConnectors(options.hosts())) {
      if (options.toolDevice().isEmpty()) {
        Controller controller =
            new Controller(
                options.controller().withOutside(scriptConnectors.connectors()), builtins);
        return run(file, controller, options, recorded, interruption, wall, console);
      }
      try (ToolSerialLine tool = ToolSerialOption.line(options.toolDevice())) {
        Connectors all = scriptConnectors.connectors().withToolSerial(tool);
        Controller controller = new Controller(options.controller().withOutside(all), builtins);
        try (var _ = open(tool, controller)) {
          return run(file, controller, options, recorded, interruption, wall, console);
        }
      } catch (IOException e) {
        console.complain("pendant run: " + CommandLanguage.shown(e.getMessage()));
        return ExitCode.UNAVAILABLE;
      }
    }
  }

  /** Programs reach the tool's serial line as they do on a robot, by a socket. */
  private static ToolSerialServer open(ToolSerialLine tool, Controller controller)
      throws IOException {
    PortNumbers numbers = new PortNumbers(InetAddress.getLoopbackAddress(), 0, false);
    return ToolSerialServer.open(tool, numbers, ServerLog.of(controller));
  }

  private static ExitCode run(
      RunnableFile file,
      Controller controller,
      RunOptions options,
      Recorded recorded,
      Interruption interruption,
      WallLimit wall,
      Console console)
      throws UsageException {
    if (file.source().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    Source source = file.source().get();
    LoadResult loadResult = controller.load(source);
    Report.diagnostics(source, loadResult.diagnostics()).forEach(console::complainInLines);
    file.wrongInReceived(loadResult.diagnostics()).forEach(console::complainFromEnglish);
    if (loadResult.program().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    Program program = loadResult.program().get();
    recorded.columns().check(program);
    var _ = controller.submit(recorded.columns().command());
    interruption.hold();
    ExitCode code;
    Optional<LineReport> report =
        recorded
            .profile()
            .map(wanted -> new LineReport(wanted, file, controller, options.controller().safety()));
    RunRecord record = RunRecord.open(recorded.file(), recorded.columns(), controller, console);
    try (record) {
      FrameWatcher watcher =
          report.isPresent() ? new FrameWatchers(List.of(record, report.get())) : record;
      code =
          new HeadlessRun(file, controller, options, interruption, wall, console, watcher)
              .run(program);
    }
    console.flush();
    if (report.isPresent()) {
      report.get().write();
    }
    interruption.release();
    return record.failed() ? code.or(ExitCode.WRONG_USAGE) : code;
  }
}
