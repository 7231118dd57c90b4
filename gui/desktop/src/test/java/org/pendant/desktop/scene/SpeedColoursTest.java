package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class SpeedColoursTest {
  private static double luminance(int rgb) {
    return 0.2126 * linear(rgb >> 16 & 0xFF)
        + 0.7152 * linear(rgb >> 8 & 0xFF)
        + 0.0722 * linear(rgb & 0xFF);
  }

  private static double linear(int channel) {
    return Math.pow(channel / 255.0, 2.2);
  }

  @Test
  void fasterIsLighter() {
    double last = 0;
    for (int i = 0; i <= 100; i++) {
      double luminance = luminance(SpeedColours.rgb(i / 100.0));
      assertTrue(luminance > last - 0.002, "darker at " + i + " %: " + luminance);
      last = luminance;
    }
    assertTrue(last > 2 * luminance(SpeedColours.rgb(0)));
  }

  @Test
  void slowIsBlueAndFastIsOrange() {
    assertEquals(0x2648BE, SpeedColours.rgb(0));
    assertEquals(0xF9913C, SpeedColours.rgb(1));
  }

  @Test
  void whatIsOutsideCountsAsTheEnd() {
    assertEquals(SpeedColours.rgb(0), SpeedColours.rgb(-1));
    assertEquals(SpeedColours.rgb(1), SpeedColours.rgb(7));
  }
}
