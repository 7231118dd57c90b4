package org.pendant.protocols.panel;

import java.nio.file.Path;
import org.pendant.controller.file.ProgramsFolder;

/**
 * What a pendant belongs to.
 *
 * @param robotId an id of the library of arms
 * @param programs where programs and installations are
 * @param logs folder for log files and reports; made when it is needed
 */
public record PanelSetup(String robotId, ProgramsFolder programs, Path logs) {}
