package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;

/** Command {@code pendant serve}: a controller with all its ports, until it is told to end. */
final class ServeCommand implements Subcommand {

  @Override
  public String name() {
    return "serve";
  }

  @Override
  public String operands() {
    return "";
  }

  @Override
  public List<Option> options() {
    return ServeOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException(text("takesNoFile", arguments.operands().getFirst()));
    }
    Optional<CellFile> file = CellFile.of(arguments);
    List<CellFile.Member> members =
        file.isPresent()
            ? file.get()
                .members(
                    arguments,
                    (installation, robot) ->
                        RunOptions.controller(arguments, installation, robot, Optional.empty()),
                    Optional.empty())
            : List.of();
    List<ServeOptions> robots =
        file.isPresent()
            ? ServeOptions.of(arguments, file.get(), members)
            : ServeOptions.of(arguments);
    Optional<ServedCell> cell =
        file.isPresent()
            ? Optional.of(new ServedCell(file.get(), members, robots, console))
            : Optional.empty();
    InstallationOption.tell(arguments, console);
    Interruption interruption = Interruption.listen("theServer");
    try (interruption) {
      interruption.hold();
      ExitCode code = new Service(robots, cell, interruption, console).run();
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      interruption.closeWith(code);
      return code;
    }
  }
}
