package org.pendant.desktop.scene.mesh;

import java.util.List;
import java.util.Map;

/**
 * Floor scale: lengths written on the floor beside the axes, drawn by strokes: no font is needed,
 * and they lie in the plane of the floor.
 */
public final class FloorScale {
  private static final double HEIGHT_M = 0.048;

  /** Widths and distances as shares of the height. */
  private static final double WIDTH = 0.6;

  private static final double ADVANCE = 0.85;
  private static final double NARROW_ADVANCE = 0.45;
  private static final double BESIDE_AXIS = 0.45;

  /** Strokes of each sign: points of a grid of two by four, x then y, a line for each list. */
  private static final Map<Character, List<double[]>> STROKES =
      Map.ofEntries(
          Map.entry(
              '0',
              List.of(
                  new double[] {
                    0, 1, 0.3, 0.3, 1, 0, 1.7, 0.3, 2, 1, 2, 3, 1.7, 3.7, 1, 4, 0.3, 3.7, 0, 3, 0, 1
                  })),
          Map.entry('1', List.of(new double[] {0, 3, 1, 4, 1, 0})),
          Map.entry('2', List.of(new double[] {0, 3, 1, 4, 2, 3, 2, 2, 0, 0, 2, 0})),
          Map.entry('3', List.of(new double[] {0, 4, 2, 4, 1, 2, 2, 2, 2, 1, 1, 0, 0, 0})),
          Map.entry('4', List.of(new double[] {2, 1, 0, 1, 1, 4}, new double[] {1, 2, 1, 0})),
          Map.entry('5', List.of(new double[] {2, 4, 0, 4, 0, 2, 1, 2, 2, 1, 1, 0, 0, 0})),
          Map.entry('.', List.of(new double[] {0.3, 0, 0.7, 0, 0.7, 0.4, 0.3, 0.4, 0.3, 0})),
          Map.entry('-', List.of(new double[] {0, 2, 2, 2})),
          Map.entry(
              'm', List.of(new double[] {0, 0, 0, 2, 1, 2, 1, 0}, new double[] {1, 2, 2, 2, 2, 0})),
          Map.entry('i', List.of(new double[] {1, 0, 1, 2}, new double[] {1, 2.8, 1, 3.1})),
          Map.entry('n', List.of(new double[] {0, 0, 0, 2, 1.5, 2, 1.5, 0})),
          Map.entry(' ', List.of()));

  private FloorScale() {}

  /** Which way signs stand on the floor: quarter turns from reading along x. */
  public static int quarters(double azimuthRad) {
    return Math.floorMod(Math.round((azimuthRad + Math.PI / 2) / (Math.PI / 2)), 4);
  }

  /**
   * Labels on both axes of the base frame, to both sides.
   *
   * @param grid where, and what
   * @param farthestM how far from the middle they go, m
   * @param heightM of the floor, m
   * @param quarters {@link #quarters} of the camera
   * @param xRgb colour on the x axis, 0xRRGGBB
   * @param yRgb colour on the y axis, 0xRRGGBB
   */
  public static Lines of(
      FloorGrid grid, double farthestM, double heightM, int quarters, int xRgb, int yRgb) {
    Lines lines = new Lines();
    for (int strong = 1; strong * grid.strongM() <= farthestM; strong++) {
      double atM = strong * grid.strongM();
      String text = grid.text(strong);
      write(lines, text, atM, 0, heightM, quarters, xRgb);
      write(lines, "-" + text, -atM, 0, heightM, quarters, xRgb);
      write(lines, text, 0, atM, heightM, quarters, yRgb);
      write(lines, "-" + text, 0, -atM, heightM, quarters, yRgb);
    }
    return lines;
  }

  private static void write(
      Lines lines, String text, double x, double y, double z, int quarters, int rgb) {
    double cos = quarters == 0 ? 1 : quarters == 2 ? -1 : 0;
    double sin = quarters == 1 ? 1 : quarters == 3 ? -1 : 0;
    double right = BESIDE_AXIS * HEIGHT_M;
    double up = BESIDE_AXIS * HEIGHT_M;
    for (int letter = 0; letter < text.length(); letter++) {
      for (double[] stroke : STROKES.get(text.charAt(letter))) {
        for (int i = 0; i < stroke.length; i += 2) {
          double a = right + WIDTH * HEIGHT_M * stroke[i] / 2;
          double b = up + HEIGHT_M * stroke[i + 1] / 4;
          double atX = x + cos * a - sin * b;
          double atY = y + sin * a + cos * b;
          if (i == 0) {
            lines.from(atX, atY, z, rgb, 1);
          } else {
            lines.to(atX, atY, z, rgb, 1);
          }
        }
      }
      boolean narrow = text.charAt(letter) == '.' || text.charAt(letter) == ' ';
      right += (narrow ? NARROW_ADVANCE : ADVANCE) * HEIGHT_M;
    }
  }
}
