package org.pendant.command;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.language.source.Source;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.script.vm.LoadResult;

/** Served script: the cell's own program, which runs from the start and has no ports. */
final class ServedScript implements AutoCloseable {
  private final Robot robot;
  private final Source source;
  private final StateBroadcaster frames;
  private final Console console;
  private Optional<LogPrinter> printer = Optional.empty();

  /**
   * A script on its robot.
   *
   * @param robot the controller, which is driven
   */
  ServedScript(RunnableFile file, Robot robot, Console console) {
    this.robot = robot;
    this.console = console;
    source = file.source().orElseThrow();
    frames = new StateBroadcaster(robot.feed(), ServerLog.of(robot));
  }

  /** Starts it, and says what is wrong with it; answers whether it could be started. */
  boolean start() {
    LoadResult result = robot.load(source);
    List<String> wrong = Report.diagnostics(source, result.diagnostics());
    wrong.forEach(console::complainInLines);
    if (result.program().isEmpty()) {
      return false;
    }
    Optional<ProgramsFolder> folder = Optional.of(ProgramsFolder.of(source.name()));
    var _ = robot.submit(new ProgramCommand.StartProgram(result.program().get(), folder));
    return true;
  }

  /** Prints from now on what it says. */
  void printLog() {
    LogPrinter log = new LogPrinter(robot, console, "cell: ", _ -> Optional.empty());
    printer = Optional.of(log);
    frames.add(log::look);
  }

  @Override
  public void close() {
    try (frames) {
      printer.ifPresent(LogPrinter::close);
    }
  }
}
