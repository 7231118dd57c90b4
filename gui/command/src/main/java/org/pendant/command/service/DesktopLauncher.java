package org.pendant.command.service;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Desktop launcher: the service that opens the window for {@code pendant open}. */
public interface DesktopLauncher {

  /**
   * Opens the window and waits until it is closed.
   *
   * @param files programs and recordings to open in it
   * @param ports where others reach the controller from the start; empty for nowhere
   * @param installation how the controller is set up from the start; empty for not at all
   * @param wishes what the user says of the arm's simulation
   * @param access is shown the controllers of the window as they come and go; empty for nobody
   * @throws DesktopUnavailable if there is no display, or it cannot be used
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void open(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes,
      Optional<RobotAccess> access)
      throws DesktopUnavailable, InterruptedException;

  /**
   * Makes the window, uses it and closes it without showing it, for a JVM that notes which classes
   * are loaded.
   *
   * @param program that is run in it
   * @throws DesktopUnavailable if there is no display, or it cannot be used
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void train(Path program) throws DesktopUnavailable, InterruptedException;
}
