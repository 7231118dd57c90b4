package org.pendant.controller.eip;

import static org.pendant.controller.eip.AssemblyDataTexts.text;

import java.util.Set;

/**
 * Assembly pair: the two assemblies of one connection, as {@code add_configuration} makes them
 * (manual 21.1.1).
 *
 * @param toPlcId instance that the robot writes and the scanner reads
 * @param toPlcBytes its size
 * @param fromPlcId instance that the scanner writes and the robot reads
 * @param fromPlcBytes its size
 */
public record AssemblyPair(int toPlcId, int toPlcBytes, int fromPlcId, int fromPlcBytes) {
  /** The instance that is built in for robot to scanner. */
  public static final int BUILT_IN_TO_PLC = 100;

  /** The instance that is built in for scanner to robot. */
  public static final int BUILT_IN_FROM_PLC = 112;

  /** The instance without data that a connection names as its configuration. */
  public static final int CONFIGURATION = 1;

  /** The largest assembly: what fits an Ethernet frame with its headers. */
  public static final int MAX_BYTES = 1400;

  private static final int MAX_ID = 0xFFFF;
  private static final Set<Integer> TAKEN =
      Set.of(CONFIGURATION, BUILT_IN_TO_PLC, BUILT_IN_FROM_PLC);

  /**
   * Checks numbers and sizes.
   *
   * @throws IllegalArgumentException if one of them cannot be
   */
  public AssemblyPair {
    checkId(toPlcId);
    checkId(fromPlcId);
    checkBytes(toPlcId, toPlcBytes);
    checkBytes(fromPlcId, fromPlcBytes);
    if (toPlcId == fromPlcId) {
      throw new IllegalArgumentException(text("sameInstance", toPlcId));
    }
  }

  private static void checkId(int id) {
    if (id < 1 || id > MAX_ID) {
      throw new IllegalArgumentException(text("instanceRange", id, MAX_ID));
    }
    if (TAKEN.contains(id)) {
      throw new IllegalArgumentException(text("builtIn", id));
    }
  }

  private static void checkBytes(int id, int bytes) {
    if (bytes < 1 || bytes > MAX_BYTES) {
      throw new IllegalArgumentException(text("instanceSize", id, bytes, MAX_BYTES));
    }
  }
}
