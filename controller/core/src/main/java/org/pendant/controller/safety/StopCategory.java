package org.pendant.controller.safety;

/** Stop category: how the arm is stopped (IEC 60204-1, 9.2.2). */
public enum StopCategory {
  /** Power is cut at once, the brakes stop the arm beside its path. */
  ZERO,
  /** The arm stops on its path, then power is cut. */
  ONE,
  /** The arm stops on its path and is kept there. */
  TWO
}
