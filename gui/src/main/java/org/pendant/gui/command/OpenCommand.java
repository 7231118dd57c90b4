package org.pendant.gui.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** {@code pendant open FILE...}: opens the desktop with programs. */
final class OpenCommand implements Subcommand {

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
    return List.of();
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
    return new DesktopStart(console).run(files);
  }
}
