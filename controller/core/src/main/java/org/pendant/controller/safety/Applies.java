package org.pendant.controller.safety;

import java.util.Locale;

/** Applicability: when a plane or a tool direction restricts the arm. */
public enum Applies {
  /** While the normal limits hold. */
  NORMAL,
  /** While the reduced limits hold. */
  REDUCED,
  BOTH,
  /** It restricts nothing itself: beyond it the reduced limits hold. */
  TRIGGERS_REDUCED;

  /** Whether it restricts the arm now. */
  public boolean restricts(boolean reduced) {
    return switch (this) {
      case NORMAL -> !reduced;
      case REDUCED -> reduced;
      case BOTH -> true;
      case TRIGGERS_REDUCED -> false;
    };
  }

  /** The name as people type it, such as {@code triggers_reduced}. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
