package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.gl.Quality;

final class AdaptiveQualityTest {
  private static final double MS = 1e6;

  private final AdaptiveQuality pace = new AdaptiveQuality();

  private void take(int pictures, Quality drawn, double ms) {
    for (int i = 0; i < pictures; i++) {
      pace.took(drawn, ms * MS);
    }
  }

  @Test
  void aGpuAlwaysDrawsTheBest() {
    take(50, Quality.FULL, 4);

    assertEquals(Quality.FULL, pace.quality());
  }

  @Test
  void slowPicturesAreDrawnWorseAtOnce() {
    pace.took(Quality.FULL, 45 * MS);
    assertEquals(Quality.SMOOTH, pace.quality());

    pace.took(Quality.FULL, 90 * MS);
    pace.took(Quality.FULL, 90 * MS);
    assertEquals(Quality.SWIFT, pace.quality());
  }

  @Test
  void theSlowestMachineHalvesThePicture() {
    pace.took(Quality.FULL, 2_000 * MS);

    assertEquals(Quality.HALF, pace.quality());
  }

  @Test
  void aHiccupChangesNothing() {
    take(5, Quality.FULL, 10);
    pace.took(Quality.FULL, 500 * MS);

    assertEquals(Quality.FULL, pace.quality());
  }

  @Test
  void betterComesAfterAWhileAndStepByStep() {
    pace.took(Quality.FULL, 2_000 * MS);
    take(10, Quality.HALF, 1);
    assertEquals(Quality.HALF, pace.quality());

    take(15, Quality.HALF, 1);
    assertEquals(Quality.SWIFT, pace.quality());

    take(40, Quality.SWIFT, 2);
    assertEquals(Quality.FULL, pace.quality());
  }

  @Test
  void whatBarelyFitsStaysAsItIs() {
    pace.took(Quality.FULL, 60 * MS);
    assertEquals(Quality.SWIFT, pace.quality());

    // As much as the better step may take at most, and nothing to spare.
    take(100, Quality.SWIFT, 32 * 0.28 / 0.65);

    assertEquals(Quality.SWIFT, pace.quality());
  }

  @Test
  void anotherSizeStartsAnew() {
    take(5, Quality.FULL, 10);
    pace.forget();
    pace.took(Quality.FULL, 200 * MS);

    assertEquals(Quality.HALF, pace.quality());
  }
}
