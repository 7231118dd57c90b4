package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.DesktopUnavailable;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;

/** Desktop launcher of the command line; no other class of the desktop is loaded before it. */
public final class WindowLauncher implements DesktopLauncher {

  @Override
  public void train(Path program) throws DesktopUnavailable, InterruptedException {
    onDisplay(() -> Desktop.train(program));
  }

  @Override
  public void open(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes,
      Optional<RobotAccess> access)
      throws DesktopUnavailable, InterruptedException {
    onDisplay(() -> Desktop.open(files, ports, installation, wishes, access).awaitClosed());
  }

  /** What needs a display. */
  private interface Use {
    void run() throws InterruptedException;
  }

  private static void onDisplay(Use use) throws DesktopUnavailable, InterruptedException {
    try {
      if (GraphicsEnvironment.isHeadless()) {
        throw new DesktopUnavailable(text("thereIsNoDisplay"));
      }
      // Says at once whether the display can be used.
      GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
      use.run();
    } catch (AWTError | HeadlessException | UnsatisfiedLinkError e) {
      throw new DesktopUnavailable(e.getMessage(), e);
    }
  }
}
