package org.pendant.kit.icon;

import java.awt.Color;
import java.util.Locale;

/** Glyph: a drawing in one colour that any screen may use. */
public enum Glyph {
  PLAY,
  PAUSE,
  STOP,
  STEP,
  POWER,
  RUN,
  PROGRAM,
  SCRIPT,
  MOVE,
  SIGNALS,
  INSTALLATION,
  CELL,
  LOG,
  PLOT,
  LEFT,
  RIGHT,
  DOWN,
  MORE,
  WARNING,
  ERROR,
  INFO,
  QUESTION,
  ROBOT,
  UNFOLD,
  CHECK,
  CROSS,
  RING,
  SKIP;

  /**
   * In the colour of the component's text.
   *
   * @param size of its sides, in pixels before scaling
   */
  public SvgIcon icon(int size) {
    return SvgIcon.of("glyph/" + name().toLowerCase(Locale.ROOT), size);
  }

  /** In a colour of its own, as {@link #icon(int)}. */
  public SvgIcon icon(int size, Color color) {
    return icon(size).in(color);
  }
}
