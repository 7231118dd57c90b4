package org.pendant.command;

import java.util.List;

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
  public String summary() {
    return "run a controller that others reach by the ports of the real one";
  }

  @Override
  public List<Option> options() {
    return ServeOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException("takes no file, it was given " + arguments.operands().getFirst());
    }
    List<ServeOptions> robots = ServeOptions.of(arguments);
    InstallationOption.tell(arguments, console);
    Interruption interruption = Interruption.listen("the server");
    try (interruption) {
      interruption.hold();
      ExitCode code = new Service(robots, interruption, console).run();
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      interruption.closeWith(code);
      return code;
    }
  }
}
