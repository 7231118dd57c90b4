package org.pendant.motion.offset;

/**
 * Offset type: in which frame a path offset is meant; in the manual's order, from 1 on (manual
 * 15.37).
 */
public enum OffsetType {
  /** Along the axes of the base. */
  BASE,
  /** In the frame of the TCP on its path. */
  TCP,
  /** Along the path: x forward, y to the side, z completes them. */
  MOTION,
  /** The pose of the base in a world in which the path is meant. */
  WORLD;

  /**
   * The type with a number of the manual.
   *
   * @param id 1 to 4
   */
  public static OffsetType of(int id) {
    return values()[id - 1];
  }
}
