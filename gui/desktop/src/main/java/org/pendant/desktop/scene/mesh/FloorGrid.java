package org.pendant.desktop.scene.mesh;

import org.pendant.desktop.unit.DisplayUnit;

/**
 * Floor grid: how far apart the lines on floors and planes are, and what is written beside them.
 */
public enum FloorGrid {
  METRES(0.1) {
    @Override
    public String text(int strong) {
      int tenths = strong * FINE_IN_STRONG;
      return tenths % 10 == 0 ? tenths / 10 + " m" : tenths / 10.0 + " m";
    }
  },
  INCHES(4 * 0.0254) {
    @Override
    public String text(int strong) {
      return 4 * FINE_IN_STRONG * strong + " in";
    }
  };

  /** So many steps of the fine lines are one of the strong ones. */
  public static final int FINE_IN_STRONG = 5;

  private final double fineM;

  FloorGrid(double fineM) {
    this.fineM = fineM;
  }

  /** The one for people who read lengths in this unit. */
  public static FloorGrid of(DisplayUnit length) {
    return length == DisplayUnit.INCH ? INCHES : METRES;
  }

  /** From one fine line to the next, m. */
  public double fineM() {
    return fineM;
  }

  /** From one strong line to the next, m. */
  public double strongM() {
    return FINE_IN_STRONG * fineM;
  }

  /** What is written at a strong line, counted from the middle. */
  public abstract String text(int strong);
}
