package org.pendant.controller.encoder;

import org.pendant.controller.io.Signal;

/**
 * Pulse decoder: how the levels of two inputs, looked at once a frame, become ticks.
 *
 * @param kind what counts
 * @param a the first input
 * @param b the second one; only a quadrature signal has it
 */
public record PulseDecoder(Kind kind, Signal a, Signal b) {

  /** What counts as a tick; in the manual's order, from type 1 on (manual 15.3). */
  public enum Kind {
    /** Every edge of two square waves, a quarter of a period apart; A leads going forward. */
    QUADRATURE,
    /** Every edge of one input. */
    BOTH_EDGES,
    RISING_EDGE,
    FALLING_EDGE;

    /**
     * The kind with a number of the manual.
     *
     * @param type 1 to 4
     */
    public static Kind of(int type) {
      return values()[type - 1];
    }

    /** Whether ticks may be negative. */
    boolean bothWays() {
      return this == QUADRATURE;
    }
  }

  /**
   * Ticks between two frames: -1, 0 or 1. When both inputs of a quadrature signal have changed, the
   * direction is not known, and nothing counts.
   */
  int ticks(boolean wasA, boolean wasB, boolean isA, boolean isB) {
    boolean edge = wasA != isA;
    return switch (kind) {
      case QUADRATURE -> quarter(isA, isB) == quarter(wasA, wasB) ? 0 : step(wasA, wasB, isA, isB);
      case BOTH_EDGES -> edge ? 1 : 0;
      case RISING_EDGE -> edge && isA ? 1 : 0;
      case FALLING_EDGE -> edge && wasA ? 1 : 0;
    };
  }

  private static int step(boolean wasA, boolean wasB, boolean isA, boolean isB) {
    int quarters = quarter(isA, isB) - quarter(wasA, wasB) & 3;
    return switch (quarters) {
      case 1 -> 1;
      case 3 -> -1;
      default -> 0;
    };
  }

  /** Where in its period a quadrature signal is that goes forward: low, A, A and B, B. */
  private static int quarter(boolean a, boolean b) {
    if (a) {
      return b ? 2 : 1;
    }
    return b ? 3 : 0;
  }
}
