package org.pendant.desktop.scene.gl;

import org.joml.Vector3f;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.mesh.Finish;

/** Paints: colours as shaders take them. */
final class Paints {
  private Paints() {}

  /** Colour and gloss of every finish, four numbers each, in the order of their numbers. */
  static float[] finishes(SceneTheme theme) {
    float[] fours = new float[4 * Finish.values().length];
    for (Finish finish : Finish.values()) {
      int at = 4 * finish.number();
      Vector3f linear = linear(theme.rgb(finish));
      fours[at] = linear.x;
      fours[at + 1] = linear.y;
      fours[at + 2] = linear.z;
      fours[at + 3] = gloss(finish);
    }
    return fours;
  }

  /** From dull, 0, to polished, 1; below 0 for marks, which shine by themselves. */
  private static float gloss(Finish finish) {
    return switch (finish) {
      case METAL -> 0.9f;
      case LID -> 0.55f;
      case SHELL -> 0.5f;
      case SEAL -> 0.15f;
      case OBJECT, TOUCHED, TOOL, LOAD -> 0.2f;
      case AXIS_X, AXIS_Y, AXIS_Z -> -1;
    };
  }

  /** A colour proportional to the light, for what is lit. */
  static Vector3f linear(int rgb) {
    Vector3f screen = screen(rgb);
    return new Vector3f(linear(screen.x), linear(screen.y), linear(screen.z));
  }

  /** A colour as screens have it, for what is not lit. */
  static Vector3f screen(int rgb) {
    return new Vector3f((rgb >> 16 & 0xFF) / 255f, (rgb >> 8 & 0xFF) / 255f, (rgb & 0xFF) / 255f);
  }

  private static float linear(float screen) {
    return (float) Math.pow(screen, 2.2);
  }
}
