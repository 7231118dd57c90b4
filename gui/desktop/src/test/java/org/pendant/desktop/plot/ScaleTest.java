package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class ScaleTest {

  @Test
  void stepsAreOneTwoOrFiveTimesAPowerOfTen() {
    assertEquals(0.2, Scale.roundStep(0.11), 1e-15);
    assertEquals(50, Scale.roundStep(21), 1e-12);
    assertEquals(10, Scale.roundStep(9.9), 1e-12);
    assertEquals(1, Scale.roundStep(1), 1e-15);
  }

  @Test
  void ticksAreRoundAndHaveTheDigitsOfTheStep() {
    Scale scale = Scale.around(-0.13, 0.27, 5);
    assertEquals(List.of("-0.2", "-0.1", "0.0", "0.1", "0.2", "0.3"), texts(scale));
  }

  private static List<String> texts(Scale scale) {
    return scale.ticks().stream().map(scale::text).toList();
  }

  @Test
  void anAxisOfOneValueHasItInTheMiddle() {
    Scale scale = Scale.around(5, 5, 4);
    assertTrue(scale.low() < 5 && scale.high() > 5);
  }

  @Test
  void anAxisAlwaysHasWhatItIsAround() {
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      double low = random.nextGaussian() * Math.pow(10, random.nextInt(-6, 7));
      double high = low + Math.abs(random.nextGaussian()) * Math.pow(10, random.nextInt(-6, 7));
      Scale scale = Scale.around(low, high, 5);
      assertTrue(scale.low() <= low && high <= scale.high(), low + " to " + high + ": " + scale);
      assertTrue(scale.ticks().size() <= 8, low + " to " + high + ": " + scale);
    }
  }
}
