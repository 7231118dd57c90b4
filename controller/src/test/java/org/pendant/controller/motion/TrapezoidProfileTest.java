package org.pendant.controller.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class TrapezoidProfileTest {
  private static final int CASES = 1000;
  private final SplittableRandom random = new SplittableRandom(1);

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  @Test
  void durationOfALongMoveIsDistanceBySpeedPlusOneRamp() {
    assertEquals(10 / 2.0 + 2 / 4.0, TrapezoidProfile.of(10, 2, 4).durationS(), 1e-15);
  }

  @Test
  void durationOfAShortMoveIsTwoRampsOfATriangle() {
    TrapezoidProfile profile = TrapezoidProfile.of(0.01, 2, 4);
    assertEquals(2 * Math.sqrt(0.01 / 4), profile.durationS(), 1e-15);
    assertEquals(Math.sqrt(0.01 * 4), profile.cruiseSpeed(), 1e-15);
  }

  @Test
  void noDistanceTakesNoTime() {
    TrapezoidProfile profile = TrapezoidProfile.of(0, 1, 1);
    assertEquals(0, profile.durationS());
    assertEquals(0, profile.position(0));
    assertEquals(0, profile.speed(0));
  }

  @Test
  void keepsItsLimitsAndMeetsItsEnds() {
    for (int i = 0; i < CASES; i++) {
      double distance = between(0, 6);
      double speed = between(0.01, 3);
      double acceleration = between(0.05, 15);
      String input = distance + ", " + speed + ", " + acceleration;
      TrapezoidProfile profile = TrapezoidProfile.of(distance, speed, acceleration);
      check(profile, distance, input);
      assertTrue(profile.cruiseSpeed() <= speed * (1 + 1e-12), input);
      assertEquals(acceleration, profile.acceleration(), 0, input);
    }
  }

  @Test
  void takesExactlyTheTimeGivenWithASpeedNoMoreThanTwiceTheMean() {
    for (int i = 0; i < CASES; i++) {
      double distance = between(1e-6, 6);
      double duration = between(0.01, 20);
      double acceleration = i % 3 == 0 ? 0 : between(0.05, 15);
      String input = distance + ", " + duration + ", " + acceleration;
      TrapezoidProfile profile = TrapezoidProfile.withDuration(distance, duration, acceleration);
      assertEquals(duration, profile.durationS(), 0, input);
      double mean = distance / duration;
      assertTrue(profile.cruiseSpeed() >= mean * (1 - 1e-12), input);
      assertTrue(profile.cruiseSpeed() <= 2 * mean * (1 + 1e-12), input);
      check(profile, distance, input);
    }
  }

  /** Distance is the integral of speed, and speed that of acceleration, within a small step. */
  private void check(TrapezoidProfile profile, double distance, String input) {
    double end = profile.durationS();
    assertEquals(0, profile.position(0), 0, input);
    assertEquals(distance, profile.position(end), 0, input);
    assertEquals(0, profile.speed(0), 0, input);
    assertEquals(0, profile.speed(end), 0, input);
    double step = end / 400;
    for (int k = 0; k < 400; k++) {
      double from = k * step;
      double to = from + step;
      double covered = profile.position(to) - profile.position(from);
      assertTrue(covered >= -1e-12, input);
      assertEquals(
          step * profile.speed(from + step / 2),
          covered,
          profile.acceleration() * step * step + 1e-12,
          input);
      assertTrue(
          Math.abs(profile.speed(to) - profile.speed(from))
              <= profile.acceleration() * step * (1 + 1e-9) + 1e-12,
          input);
      assertTrue(profile.speed(to) <= profile.cruiseSpeed() * (1 + 1e-12), input);
    }
  }
}
