package org.pendant.window;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** Pictures with 256 colours: a third of the bytes, and people see no difference. */
final class SmallPicture {
  private static final int COLOURS = 256;

  private SmallPicture() {}

  /**
   * A picture with a palette of its own; colours that are not in it become the nearest that are.
   */
  static BufferedImage of(BufferedImage picture) {
    int width = picture.getWidth();
    int height = picture.getHeight();
    int[] pixels = picture.getRGB(0, 0, width, height, null, 0, width);
    int[] palette = palette(pixels);
    BufferedImage small =
        new BufferedImage(
            width,
            height,
            BufferedImage.TYPE_BYTE_INDEXED,
            new IndexColorModel(8, palette.length, palette, 0, false, -1, 0));
    Map<Integer, Integer> nearest = new HashMap<>();
    int[] indices = new int[pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      indices[i] = nearest.computeIfAbsent(pixels[i], colour -> nearest(palette, colour));
    }
    small.getRaster().setPixels(0, 0, width, height, indices);
    return small;
  }

  /** Half of it what is frequent; half what is rare and unlike all others, such as a red dot. */
  private static int[] palette(int[] pixels) {
    Map<Integer, Integer> counts = new HashMap<>();
    for (int pixel : pixels) {
      counts.merge(pixel, 1, Integer::sum);
    }
    int[] colours =
        counts.entrySet().stream()
            .sorted(
                Map.Entry.<Integer, Integer>comparingByValue()
                    .reversed()
                    .thenComparing(Map.Entry.comparingByKey()))
            .mapToInt(Map.Entry::getKey)
            .toArray();
    int[] palette = Arrays.copyOf(colours, Math.min(COLOURS, colours.length));
    int[] away = new int[colours.length];
    Arrays.fill(away, Integer.MAX_VALUE);
    for (int size = 1; size <= palette.length; size++) {
      int farthest = 0;
      for (int i = 0; i < colours.length; i++) {
        away[i] = Math.min(away[i], distance(palette[size - 1], colours[i]));
        farthest = away[i] > away[farthest] ? i : farthest;
      }
      if (size >= COLOURS / 2 && size < palette.length) {
        palette[size] = colours[farthest];
      }
    }
    return palette;
  }

  private static int nearest(int[] palette, int colour) {
    int best = 0;
    for (int i = 1; i < palette.length; i++) {
      if (distance(palette[i], colour) < distance(palette[best], colour)) {
        best = i;
      }
    }
    return best;
  }

  private static int distance(int a, int b) {
    int red = (a >> 16 & 255) - (b >> 16 & 255);
    int green = (a >> 8 & 255) - (b >> 8 & 255);
    int blue = (a & 255) - (b & 255);
    return red * red + green * green + blue * blue;
  }
}
