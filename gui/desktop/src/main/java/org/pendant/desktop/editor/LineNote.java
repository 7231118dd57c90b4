package org.pendant.desktop.editor;

import java.awt.Color;
import java.awt.FontMetrics;
import java.util.List;
import org.pendant.kit.theme.Palette;

/**
 * Line note: what stands behind a line in a quiet colour.
 *
 * @param parts of it, the most important first: where there is less room the last are left out
 * @param share of the time of the run that the line took, 0 to 1
 * @param heat what the share is, in words
 * @param whole all of it in words, a line each
 */
public record LineNote(List<String> parts, double share, String heat, String whole) {
  private static final double COOLEST = 0.12;
  private static final String BETWEEN = " \u00b7 ";

  /** Copies the parts. */
  public LineNote {
    parts = List.copyOf(parts);
  }

  /** How warm the share is: small ones can still be told from none. */
  public Color heatColour() {
    Color warm = Palette.warning();
    double strength = COOLEST + (1 - COOLEST) * Math.sqrt(Math.clamp(share, 0, 1));
    return new Color(
        warm.getRed(), warm.getGreen(), warm.getBlue(), (int) Math.round(255 * strength));
  }

  /** As many parts as there is room for, in pixels; empty if there is none for the first. */
  public String fitting(FontMetrics metrics, int room) {
    String fitting = "";
    for (int count = 1; count <= parts.size(); count++) {
      String text = String.join(BETWEEN, parts.subList(0, count));
      if (metrics.stringWidth(text) > room) {
        break;
      }
      fitting = text;
    }
    return fitting;
  }
}
