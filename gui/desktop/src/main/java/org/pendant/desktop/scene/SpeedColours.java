package org.pendant.desktop.scene;

/**
 * Speed colours from slow to fast: blue, violet, orange. They grow lighter on the way, so the order
 * is also seen by people who confuse hues, and stand out from light and dark grounds alike.
 */
public final class SpeedColours {
  private static final int[] STOPS = {0x2648BE, 0x8A4FC9, 0xD85C8C, 0xF9913C};

  private SpeedColours() {}

  /**
   * The colour as 0xRRGGBB. Half of the colours are for the slowest quarter: most work is slow, and
   * one fast move should not make all of it look the same.
   *
   * @param share 0 for rest to 1 for the fastest; what is outside counts as the end next to it
   */
  public static int rgb(double share) {
    double at = place(share) * (STOPS.length - 1);
    int stop = Math.min((int) at, STOPS.length - 2);
    double part = at - stop;
    int from = STOPS[stop];
    int to = STOPS[stop + 1];
    return mix(from, to, 16, part) | mix(from, to, 8, part) | mix(from, to, 0, part);
  }

  /** Where on a scale from the first to the last colour, 0 to 1, a speed has its place. */
  public static double place(double share) {
    return Math.sqrt(Math.clamp(share, 0, 1));
  }

  private static int mix(int from, int to, int shift, double part) {
    int a = from >> shift & 0xFF;
    int b = to >> shift & 0xFF;
    return (int) Math.round(a + (b - a) * part) << shift;
  }
}
