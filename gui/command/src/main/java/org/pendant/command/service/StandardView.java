package org.pendant.command.service;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Standard view: a direction to look from, by the axes of the base frame. */
public enum StandardView {
  /** From the right in front, and above. */
  ISO("1", -52, 24),
  /** Against y: x goes to the right. */
  FRONT("2", -90, 4),
  /** Along y: x goes to the left. */
  BACK("3", 90, 4),
  /** Along x. */
  LEFT("4", 180, 4),
  /** Against x: y goes to the right. */
  RIGHT("5", 0, 4),
  /** From above: x goes to the right, y up. */
  TOP("6", -90, 90);

  private final String key;
  private final double azimuthRad;
  private final double elevationRad;

  StandardView(String key, double azimuthDeg, double elevationDeg) {
    this.key = key;
    azimuthRad = Math.toRadians(azimuthDeg);
    elevationRad = Math.toRadians(elevationDeg);
  }

  /** Where the eye is, as an angle from x towards y, rad. */
  public double azimuthRad() {
    return azimuthRad;
  }

  /** How far above the horizontal the eye is, rad. */
  public double elevationRad() {
    return elevationRad;
  }

  /** The digit that looks from there, for keyboards. */
  public String key() {
    return key;
  }

  /** Its name in commands, such as {@code front}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The view of this name. */
  public static Optional<StandardView> named(String word) {
    return Arrays.stream(values()).filter(view -> view.word().equals(word)).findFirst();
  }

  /** All names. */
  public static List<String> words() {
    return Arrays.stream(values()).map(StandardView::word).toList();
  }
}
