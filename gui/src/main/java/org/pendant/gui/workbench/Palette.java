package org.pendant.gui.workbench;

import java.awt.Color;
import java.util.List;
import javax.swing.UIManager;

/**
 * The colours that mean something, in the present theme: each is readable as text on the window's
 * background, and they differ in lightness too, for people who do not tell red from green.
 */
public final class Palette {
  /** Okabe and Ito, Color Universal Design (2008), in the order of their contrast. */
  private static final List<Color> SERIES_LIGHT =
      List.of(
          new Color(0x0072B2),
          new Color(0xD55E00),
          new Color(0x008B66),
          new Color(0xB24E87),
          new Color(0x946B00),
          new Color(0x7A5CC0),
          new Color(0x5A5A5A),
          new Color(0x2A87B8));

  private static final List<Color> SERIES_DARK =
      List.of(
          new Color(0x56B4E9),
          new Color(0xE69F00),
          new Color(0x2BC49A),
          new Color(0xE08BBB),
          new Color(0xF0E442),
          new Color(0xB39DFF),
          new Color(0xC8C8C8),
          new Color(0xFF8A4C));

  private Palette() {}

  /** Whether the present theme is a dark one. */
  public static boolean dark() {
    Color background = UIManager.getColor("Panel.background");
    return background != null
        && background.getRed() + background.getGreen() + background.getBlue() < 3 * 128;
  }

  private static Color choose(int light, int dark) {
    return new Color(dark() ? dark : light);
  }

  /** What belongs to Pendant: the chosen screen, links, what is selected. */
  public static Color accent() {
    return choose(0x2F5D8C, 0x8DB4DC);
  }

  /** All is well, or running. */
  public static Color ok() {
    return choose(0x0B7A4B, 0x4CC38A);
  }

  /** Somebody should look. */
  public static Color warning() {
    return choose(0x8F5A00, 0xF2B24C);
  }

  /** Something is wrong, or stopped. */
  public static Color error() {
    return choose(0xB3261E, 0xFF8A80);
  }

  /** What is less important than the text around it. */
  public static Color quiet() {
    return choose(0x5F6670, 0x9AA3AE);
  }

  /** Behind what is looked for. */
  public static Color mark() {
    return choose(0xFFE08A, 0x6B5600);
  }

  /** Lines that separate. */
  public static Color line() {
    return choose(0xD5D9DE, 0x3C4147);
  }

  /** Background of a card that lies on the window. */
  public static Color card() {
    return choose(0xFFFFFF, 0x2B2F34);
  }

  /** {@code share} (0 to 1) of {@code over} on the card's background: a soft background for it. */
  public static Color tint(Color over, double share) {
    Color under = card();
    return new Color(
        mix(over.getRed(), under.getRed(), share),
        mix(over.getGreen(), under.getGreen(), share),
        mix(over.getBlue(), under.getBlue(), share));
  }

  private static int mix(int over, int under, double share) {
    return (int) Math.round(share * over + (1 - share) * under);
  }

  /** Lines of a chart, by number; they repeat after eight. */
  public static Color series(int number) {
    List<Color> colors = dark() ? SERIES_DARK : SERIES_LIGHT;
    return colors.get(Math.floorMod(number, colors.size()));
  }
}
