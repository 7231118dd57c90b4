package org.pendant.models.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;

class FloatTextTest {

  @Test
  void floatsHaveSixDecimalsWithoutTrailingZeros() {
    assertEquals("4", FloatText.of(4.0));
    assertEquals("2.123456", FloatText.of(2.123456123456));
    assertEquals("0.000025", FloatText.of(0.000025));
    assertEquals("-1.25", FloatText.of(-1.25));
    assertEquals("100000", FloatText.of(1e5));
    assertEquals("1", FloatText.of(0.9999999));
    assertEquals("10000000000", FloatText.of(1e10));
    assertEquals("123456789012.125", FloatText.of(123456789012.125));
  }

  @Test
  void theSignOfZeroIsNotShown() {
    assertEquals("0", FloatText.of(-0.0));
    assertEquals("0", FloatText.of(-4e-7));
    assertEquals("0", FloatText.of(-Double.MIN_VALUE));
    assertEquals("-0.000001", FloatText.of(-6e-7));
  }

  @Test
  void infinitiesAndNotANumberHaveNames() {
    assertEquals("inf", FloatText.of(Double.POSITIVE_INFINITY));
    assertEquals("-inf", FloatText.of(Double.NEGATIVE_INFINITY));
    assertEquals("nan", FloatText.of(Double.NaN));
  }

  @Test
  void roundingIsThatOfTheExactBinaryValue() {
    // 0.0000005 is a little below its decimal, 0.0000015 too; 2^-7 = 0.0078125 is a true tie
    assertEquals(exact(0.0000005), FloatText.of(0.0000005));
    assertEquals(exact(0.0000015), FloatText.of(0.0000015));
    assertEquals("0.007812", FloatText.of(0.0078125));
    assertEquals("0.023438", FloatText.of(0.0234375));
  }

  @Test
  void manyFloatsPrintAsTheirExactDecimalRounded() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 100_000; i++) {
      double number =
          switch (i % 4) {
            case 0 -> random.nextDouble(-10, 10);
            case 1 -> random.nextInt(-2_000_000, 2_000_000) / 2e6;
            case 2 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(-60, 60));
            default -> random.nextInt(-1000, 1000) / 128.0 + random.nextInt(1000);
          };
      assertEquals(exact(number), FloatText.of(number), () -> "number " + number);
    }
  }

  private static String exact(double number) {
    BigDecimal rounded = new BigDecimal(number).setScale(6, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  @Test
  void posesReadAsInScripts() {
    assertEquals(
        "p[0.1, -0.25, 3, 0, 1.570796, 0]",
        FloatText.of(new Pose(0.1, -0.25, 3, -0.0, Math.PI / 2, 0)));
  }
}
