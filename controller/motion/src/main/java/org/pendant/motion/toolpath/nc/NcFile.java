package org.pendant.motion.toolpath.nc;

import org.pendant.motion.PlanningException;

/** Toolpath file that has been found, and can be read. */
public interface NcFile {
  /** The last part of its name, for messages. */
  String shortName();

  /** How large it was when it was found. */
  long sizeBytes();

  /**
   * All of it; may take long, so not for the frame loop unless the file is small.
   *
   * @throws PlanningException when it cannot be read, or has grown too large
   */
  byte[] read() throws PlanningException;
}
