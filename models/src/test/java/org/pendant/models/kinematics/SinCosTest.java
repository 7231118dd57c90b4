package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class SinCosTest {
  private final double[] sin = new double[3];
  private final double[] cos = new double[3];

  @Test
  void sineAndCosineAreThoseOfMathToTheLastDigits() {
    SplittableRandom random = new SplittableRandom(7);
    random.doubles(200_000, -8, 8).forEach(this::assertNear);
  }

  @Test
  void anglesBetweenTwoStepsOfTheTableAreAsExact() {
    for (int half = -225; half <= 225; half++) {
      double between = half / 32.0;
      DoubleStream.of(Math.nextDown(between), between, Math.nextUp(between))
          .forEach(this::assertNear);
    }
  }

  @Test
  void smallAnglesKeepAllTheirDigits() {
    for (double angle : new double[] {0, 1e-300, 1e-12, -3e-9, 1e-5, 0.03}) {
      SinCos.of(angle, 0, sin, cos);
      assertEquals(Math.sin(angle), sin[0], Math.ulp(angle));
    }
  }

  @Test
  void whatIsBeyondTheTableIsComputedByMath() {
    for (double angle :
        new double[] {7, -7, 1e9, Double.MAX_VALUE, Double.NaN, Double.NEGATIVE_INFINITY}) {
      SinCos.of(angle, 1, sin, cos);
      assertEquals(Math.sin(angle), sin[1], 0);
      assertEquals(Math.cos(angle), cos[1], 0);
    }
  }

  private void assertNear(double angle) {
    SinCos.of(angle, 2, sin, cos);
    assertEquals(Math.sin(angle), sin[2], 3e-16, () -> "sine of " + angle);
    assertEquals(Math.cos(angle), cos[2], 3e-16, () -> "cosine of " + angle);
  }
}
