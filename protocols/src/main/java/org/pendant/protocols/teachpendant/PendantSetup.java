package org.pendant.protocols.teachpendant;

import java.nio.file.Path;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.protocols.externalcontrol.Drivers;

/**
 * Pendant setup: what a pendant belongs to.
 *
 * @param robotId an id of the library of arms
 * @param programs where programs and installations are
 * @param logs folder for log files and reports; made when it is needed
 * @param drivers who can be asked for the script of External Control nodes
 */
public record PendantSetup(String robotId, ProgramsFolder programs, Path logs, Drivers drivers) {
  /** Where no driver may be asked. */
  public PendantSetup(String robotId, ProgramsFolder programs, Path logs) {
    this(robotId, programs, logs, Drivers.NONE);
  }
}
