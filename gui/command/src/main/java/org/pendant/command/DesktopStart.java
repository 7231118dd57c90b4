package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.DesktopUnavailable;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;

/** Start of the desktop from the command line. */
final class DesktopStart {
  private final DesktopServices services;
  private final Console console;

  DesktopStart(DesktopServices services, Console console) {
    this.services = services;
    this.console = console;
  }

  /**
   * Opens the window and waits until it is closed.
   *
   * @param files programs to open in it
   * @param ports where others reach the controller from the start; empty for nowhere
   * @param installation how the controller is set up from the start; empty for not at all
   * @param wishes what the user says of the arm's simulation
   * @param access is shown the controllers of the window; empty for nobody
   */
  ExitCode run(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes,
      Optional<RobotAccess> access) {
    Optional<DesktopLauncher> launcher = services.launcher().get();
    if (launcher.isEmpty()) {
      return refused(text("notOnClassPath"));
    }
    try {
      launcher.get().open(files, ports, installation, wishes, access);
      return ExitCode.DONE;
    } catch (DesktopUnavailable e) {
      return refused(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCode.DONE;
    }
  }

  private ExitCode refused(String why) {
    console.complain(text("desktopCannotOpen", why));
    console.complain(text("runsWithoutDisplay"));
    return ExitCode.WRONG_USAGE;
  }
}
