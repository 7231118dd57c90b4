package org.pendant.gui.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Directions to look from, by the axes of the base frame. */
public enum StandardView {
  /** From the right in front, and above. */
  ISO(-52, 24),
  /** Against y: x goes to the right. */
  FRONT(-90, 4),
  /** Along y: x goes to the left. */
  BACK(90, 4),
  /** Along x. */
  LEFT(180, 4),
  /** Against x: y goes to the right. */
  RIGHT(0, 4),
  /** From above: x goes to the right, y up. */
  TOP(-90, 90);

  private final double azimuthRad;
  private final double elevationRad;

  StandardView(double azimuthDeg, double elevationDeg) {
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
