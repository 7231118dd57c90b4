package org.pendant.gui.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.gui.ports.PortWishes;

/** {@code pendant open FILE...}: opens the desktop with programs. */
final class OpenCommand implements Subcommand {
  private static final Option PORTS =
      new Option("--ports", "", "let others reach the controller by the ports of the real one");

  private static final List<Option> OPTIONS =
      Stream.concat(Stream.of(PORTS), PortOptions.ALL.stream()).toList();

  /** Whether {@code word} is one of its options: then {@code open} may be left out. */
  static boolean understands(String word) {
    return OPTIONS.stream()
        .anyMatch(each -> word.equals(each.name()) || word.startsWith(each.name() + "="));
  }

  @Override
  public String name() {
    return "open";
  }

  @Override
  public String operands() {
    return "FILE...";
  }

  @Override
  public String summary() {
    return "open programs in the desktop";
  }

  @Override
  public List<Option> options() {
    return OPTIONS;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    List<Path> files = new ArrayList<>();
    for (String each : arguments.operands()) {
      try {
        files.add(Path.of(each).toAbsolutePath());
      } catch (InvalidPathException e) {
        throw new UsageException(each + " is no name of a file: " + e.getReason());
      }
    }
    return new DesktopStart(console).run(files, ports(arguments));
  }

  private static Optional<PortWishes> ports(Arguments arguments) throws UsageException {
    if (arguments.has(PORTS)) {
      return Optional.of(PortOptions.wishes(arguments));
    }
    for (Option each : PortOptions.ALL) {
      if (arguments.has(each)) {
        throw new UsageException(each.name() + " is only for open ports, with " + PORTS.name());
      }
    }
    return Optional.empty();
  }
}
