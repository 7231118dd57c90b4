package org.pendant.kit.table;

import java.awt.FontMetrics;

/**
 * Middle elision: a name that is too long loses its middle: names of one kind often begin alike,
 * and end alike.
 */
public final class MiddleElision {
  private static final String LEFT_OUT = "\u2026";

  private MiddleElision() {}

  /**
   * A text, or as much of its begin and of its end as there is room for.
   *
   * @param width that there is, in pixels
   */
  public static String fit(String text, FontMetrics metrics, int width) {
    if (metrics.stringWidth(text) <= width) {
      return text;
    }
    int[] characters = text.codePoints().toArray();
    for (int kept = characters.length - 1; kept > 1; kept--) {
      int end = kept / 2;
      int begin = kept - end;
      String fitted =
          new String(characters, 0, begin).stripTrailing()
              + LEFT_OUT
              + new String(characters, characters.length - end, end).stripLeading();
      if (metrics.stringWidth(fitted) <= width) {
        return fitted;
      }
    }
    return LEFT_OUT;
  }
}
