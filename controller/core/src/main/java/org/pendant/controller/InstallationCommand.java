package org.pendant.controller;

import org.pendant.controller.command.Command;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;

/** Command about what is set up in the installation. */
public sealed interface InstallationCommand extends Command {

  /**
   * Makes the controller what an installation says, in place of what was. Refused while a program
   * runs or is paused or the arm moves, and when {@link InstallationCheck} finds something wrong.
   * Where the safety configuration differs the arm is powered off, as a real one is.
   */
  record ApplyInstallation(Installation installation) implements InstallationCommand {}

  /**
   * A fieldbus scanner that has written inputs does so no longer; what follows is up to the
   * installation.
   *
   * @param who it was, for the log
   */
  record ScannerLost(String who) implements InstallationCommand {}
}
