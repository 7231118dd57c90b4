package org.pendant.command;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.command.ServedRobot.Doors;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.models.json.JsonException;

/** Served cell: controllers that share a cell, driven by one thread, each with its own ports. */
final class ServedCell implements AutoCloseable {
  private final List<CellFile.Member> members;
  private final List<ServeOptions> options;
  private final List<Doors> doors = new ArrayList<>();
  private final Cell cell;
  private final Optional<ServedScript> script;
  private final Console console;
  private Optional<FrameLoop> loop = Optional.empty();

  /**
   * Switches the controllers on.
   *
   * @param members of the cell, in their order
   * @param options of those that have ports, which come first
   * @throws UsageException if they cannot be as the file says
   */
  ServedCell(
      CellFile file, List<CellFile.Member> members, List<ServeOptions> options, Console console)
      throws UsageException {
    this.members = members;
    this.options = options;
    this.console = console;
    List<ControllerOptions> switchedOn = new ArrayList<>();
    for (int i = 0; i < members.size(); i++) {
      Doors own = Doors.of(options.get(Math.min(i, options.size() - 1)));
      doors.add(own);
      switchedOn.add(
          own.in(
              i < options.size()
                  ? options.get(i).controller()
                  : members.get(i).options().withSystemTime(InstantSource.system())));
    }
    try {
      cell = new Cell(file.plan(), switchedOn, StandardBuiltins.create());
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    }
    Optional<RunnableFile> text =
        members.getLast().armless() ? members.getLast().program() : Optional.empty();
    script =
        text.map(each -> new ServedScript(each, cell.members().getLast().controller(), console));
  }

  /** Begins with the frames and the script; answers whether that is right. */
  boolean begin() {
    loop = Optional.of(FrameLoop.start(cell, new WallClock()));
    return script.isEmpty() || script.get().start();
  }

  /** Opens the ports of a controller. */
  ServedRobot robot(int number) {
    Cell.Member member = cell.members().get(number);
    return new ServedRobot(
        options.get(number),
        doors.get(number),
        member.controller(),
        loop.orElseThrow(),
        console,
        member.name() + ": ");
  }

  /** The file of the program that the scene names for a controller; empty for none. */
  Optional<String> program(int number) {
    return members.get(number).program().map(RunnableFile::file);
  }

  /** Prints from now on what the script says. */
  void printLog() {
    script.ifPresent(ServedScript::printLog);
  }

  @Override
  public void close() {
    script.ifPresent(ServedScript::close);
    loop.ifPresent(FrameLoop::close);
    doors.forEach(
        each -> {
          each.connectors().close();
          each.tool().close();
        });
  }
}
