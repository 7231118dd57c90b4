package org.pendant.gui.command;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.gui.ports.PortWishes;
import org.pendant.gui.session.StartInstallation;
import org.pendant.gui.shell.Desktop;

/** Opens the desktop. Nothing else of the command line loads a class of the desktop. */
final class DesktopStart {
  private final Console console;

  DesktopStart(Console console) {
    this.console = console;
  }

  /**
   * Opens the window and waits until it is closed.
   *
   * @param files programs to open in it
   * @param ports where others reach the controller from the start; empty for nowhere
   * @param installation how the controller is set up from the start; empty for not at all
   */
  ExitCode run(
      List<Path> files, Optional<PortWishes> ports, Optional<StartInstallation> installation) {
    try {
      if (GraphicsEnvironment.isHeadless()) {
        return refused("there is no display");
      }
      // Says at once whether the display can be used.
      GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
      Desktop.open(files, ports, installation).awaitClosed();
      return ExitCode.DONE;
    } catch (AWTError | HeadlessException | UnsatisfiedLinkError e) {
      return refused(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCode.DONE;
    }
  }

  private ExitCode refused(String why) {
    console.complain("pendant: the desktop cannot be opened: " + why);
    console.complain(
        "Programs run without a display too: pendant run FILE...; pendant --help lists more");
    return ExitCode.WRONG_USAGE;
  }
}
