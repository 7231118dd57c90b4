package org.pendant.kit.theme;

import java.awt.Color;
import java.util.function.IntSupplier;

/**
 * Colour of the theme: it looks itself up whenever something is painted with it. Components and
 * borders take it once and are in the right colour in every theme that is chosen later.
 */
@SuppressWarnings("serial") // never written to a stream
final class ThemeColor extends Color {
  private final transient IntSupplier rgb;

  /**
   * A colour.
   *
   * @param light what it is in the light theme
   * @param rgb what it is in the present theme, as {@link Color#getRGB} has it, opaque
   */
  ThemeColor(int light, IntSupplier rgb) {
    super(light);
    this.rgb = rgb;
  }

  /** Red, green and blue in the light theme, 8 bits each. */
  int light() {
    return super.getRGB() & 0xFFFFFF;
  }

  /** What it is in the present theme. Everything else that a colour tells comes from this. */
  @Override
  public int getRGB() {
    return 0xFF000000 | rgb.getAsInt();
  }

  @Override
  public boolean equals(Object other) {
    return super.equals(other);
  }

  /** As equal colours have it: it changes with the theme. */
  @Override
  public int hashCode() {
    return getRGB();
  }
}
