package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.whatif.VariantColumns.Width;

final class VariantColumnsTest {
  private static final List<Width> COLUMNS =
      List.of(new Width(100, 130), new Width(60, 60), new Width(140, 300), new Width(80, 80));

  @Test
  void eachHasRoomForItsContentAndTheLastTakesTheRest() {
    assertArrayEquals(new int[] {130, 60, 300, 80}, VariantColumns.fit(570, COLUMNS));
    assertArrayEquals(new int[] {130, 60, 300, 230}, VariantColumns.fit(720, COLUMNS));
  }

  @Test
  void whereThereIsLittleRoomTheLaterOfThoseThatMayBeCutIsNarrower() {
    assertArrayEquals(new int[] {130, 60, 200, 80}, VariantColumns.fit(470, COLUMNS));
    assertArrayEquals(new int[] {110, 60, 140, 80}, VariantColumns.fit(390, COLUMNS));
  }

  @Test
  void noneIsNarrowerThanItsLeast() {
    assertEquals(380, VariantColumns.least(COLUMNS));
    assertArrayEquals(new int[] {100, 60, 140, 80}, VariantColumns.fit(200, COLUMNS));
  }
}
