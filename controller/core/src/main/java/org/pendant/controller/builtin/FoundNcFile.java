package org.pendant.controller.builtin;

import org.pendant.controller.file.ProgramsFolder;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.nc.NcFile;
import org.pendant.script.value.ScriptError;

/**
 * A toolpath file of the programs folder.
 *
 * @param found where it is
 */
record FoundNcFile(ProgramsFolder.Found found) implements NcFile {
  @Override
  public String shortName() {
    return found.shortName();
  }

  @Override
  public long sizeBytes() {
    return found.sizeBytes();
  }

  @Override
  public byte[] read() throws PlanningException {
    try {
      return found.read();
    } catch (ScriptError e) {
      throw new PlanningException(e.code(), e.getMessage());
    }
  }
}
