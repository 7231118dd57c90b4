package org.pendant.desktop.debug;

import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ControlScript;

/**
 * Program launch: a program that is about to start, as it is at that moment.
 *
 * @param waitingNodes how many of its nodes wait for the script that a driver sends; 0 for none
 * @param installation says which driver is asked
 * @param script makes its text, with what the driver has sent; any thread may call it
 */
public record ProgramLaunch(
    int waitingNodes,
    Installation installation,
    Function<Optional<ControlScript>, RunScript> script) {

  /** A text that waits for no driver. */
  public static ProgramLaunch of(RunScript text) {
    return new ProgramLaunch(0, Installation.NONE, _ -> text);
  }
}
