package org.pendant.kit.theme;

import java.awt.Color;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.UIManager;

/**
 * Palette: the colours that mean something. Each is readable as text on the window's background,
 * and they differ in lightness too, for people who do not tell red from green. A colour that was
 * taken once follows the theme.
 */
public final class Palette {
  private static final ThemeColor ACCENT = color(0x2F5D8C, 0x8DB4DC);
  private static final ThemeColor OK = color(0x0B7A4B, 0x4CC38A);
  private static final ThemeColor WARNING = color(0x8F5A00, 0xF2B24C);
  private static final ThemeColor ERROR = color(0xB3261E, 0xFF8A80);
  private static final ThemeColor QUIET = color(0x5F6670, 0x9AA3AE);
  private static final ThemeColor MARK = color(0xFFE08A, 0x6B5600);
  private static final ThemeColor LINE = color(0xD5D9DE, 0x3C4147);
  private static final ThemeColor CARD = color(0xFFFFFF, 0x2B2F34);

  /** Okabe and Ito, Color Universal Design (2008), in the order of their contrast. */
  private static final List<ThemeColor> SERIES =
      List.of(
          color(0x0072B2, 0x56B4E9),
          color(0xD55E00, 0xE69F00),
          color(0x008B66, 0x2BC49A),
          color(0xB24E87, 0xE08BBB),
          color(0x946B00, 0xF0E442),
          color(0x7A5CC0, 0xB39DFF),
          color(0x5A5A5A, 0xC8C8C8),
          color(0x2A87B8, 0xFF8A4C));

  private static final Map<Integer, Color> BY_LIGHT =
      Stream.concat(Stream.of(ACCENT, OK, WARNING, ERROR, QUIET, MARK, LINE, CARD), SERIES.stream())
          .collect(Collectors.toUnmodifiableMap(ThemeColor::light, each -> each));

  private Palette() {}

  /** Whether the present theme is a dark one. */
  public static boolean dark() {
    Color background = UIManager.getColor("Panel.background");
    return background != null
        && background.getRed() + background.getGreen() + background.getBlue() < 3 * 128;
  }

  private static ThemeColor color(int light, int dark) {
    return new ThemeColor(light, () -> dark() ? dark : light);
  }

  /** What belongs to Pendant: the chosen screen, links, what is selected. */
  public static Color accent() {
    return ACCENT;
  }

  /** All is well, or running. */
  public static Color ok() {
    return OK;
  }

  /** An operator should look. */
  public static Color warning() {
    return WARNING;
  }

  /** Something is wrong, or stopped. */
  public static Color error() {
    return ERROR;
  }

  /** What is less important than the text around it. */
  public static Color quiet() {
    return QUIET;
  }

  /** Behind what is looked for. */
  public static Color mark() {
    return MARK;
  }

  /** Lines that separate. */
  public static Color line() {
    return LINE;
  }

  /** Background of a card that lies on the window. */
  public static Color card() {
    return CARD;
  }

  /** {@code share} (0 to 1) of {@code over} on the card's background: a soft background for it. */
  public static Color tint(Color over, double share) {
    return new ThemeColor(
        over.getRGB(),
        () ->
            mix(over.getRed(), CARD.getRed(), share) << 16
                | mix(over.getGreen(), CARD.getGreen(), share) << 8
                | mix(over.getBlue(), CARD.getBlue(), share));
  }

  private static int mix(int over, int under, double share) {
    return (int) Math.round(share * over + (1 - share) * under);
  }

  /** The colour that is {@code light} in the light theme, for drawings; itself if there is none. */
  public static Color ofLight(Color light) {
    return BY_LIGHT.getOrDefault(light.getRGB() & 0xFFFFFF, light);
  }

  /** Lines of a chart, by number; they repeat after eight. */
  public static Color series(int number) {
    return SERIES.get(Math.floorMod(number, SERIES.size()));
  }
}
