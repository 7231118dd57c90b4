package org.pendant.motion.profile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class ProfileLimitsTest {
  private static final int CASES = 1000;
  private final SplittableRandom random = new SplittableRandom(1);

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  private ProfileLimits anyLimits(int each) {
    double jerk = each % 2 == 0 ? Double.POSITIVE_INFINITY : between(0.5, 300);
    return new ProfileLimits(between(0.01, 3), between(0.05, 15), jerk);
  }

  @Test
  void durationOfALongMoveIsDistanceBySpeedPlusOneRamp() {
    assertEquals(10 / 2.0 + 2 / 4.0, ProfileLimits.of(2, 4).over(10).durationS(), 1e-15);
  }

  @Test
  void durationOfAShortMoveIsTwoRampsOfATriangle() {
    Profile profile = ProfileLimits.of(2, 4).over(0.01);
    assertEquals(2 * Math.sqrt(0.01 / 4), profile.durationS(), 1e-15);
    assertEquals(Math.sqrt(0.01 * 4), profile.peakSpeed(), 1e-15);
  }

  @Test
  void limitedJerkAddsTheTimeThatTheAccelerationNeedsToGrow() {
    // ramps of 2 / 4 + 4 / 16 s, the rest at 2
    Profile profile = new ProfileLimits(2, 4, 16).over(10);
    assertEquals(10 / 2.0 + 0.75, profile.durationS(), 1e-14);
  }

  @Test
  void aShortMoveOfLimitedJerkNeverReachesTheAcceleration() {
    Profile profile = new ProfileLimits(2, 4, 16).over(0.01);
    assertEquals(4 * Math.cbrt(0.01 / (2 * 16)), profile.durationS(), 1e-14);
  }

  @Test
  void noDistanceTakesNoTime() {
    Profile profile = ProfileLimits.of(1, 1).over(0);
    assertEquals(0, profile.durationS());
    assertEquals(0, profile.position(0));
    assertEquals(0, profile.speed(0));
  }

  @Test
  void refusesLimitsThatAllowNothing() {
    assertThrows(IllegalArgumentException.class, () -> ProfileLimits.of(0, 1));
    assertThrows(IllegalArgumentException.class, () -> new ProfileLimits(1, 1, Double.NaN));
  }

  @Test
  void keepsItsLimitsAndMeetsItsEndsFromRestToRest() {
    for (int i = 0; i < CASES; i++) {
      ProfileLimits limits = anyLimits(i);
      double distance = between(0, 6);
      check(limits.over(distance), limits, distance, 0, 0, distance + ", " + limits);
    }
  }

  @Test
  void keepsItsLimitsBetweenTwoSpeedsThatTheDistanceAllows() {
    for (int i = 0; i < CASES; i++) {
      ProfileLimits limits = anyLimits(i);
      double distance = between(0.001, 6);
      double from = between(0, limits.fastestBegin(distance, 0));
      double to = between(0, limits.fastestEnd(distance, from));
      if (limits.rampDistance(from, to) <= distance) {
        String input = distance + ", " + from + " to " + to + ", " + limits;
        check(limits.between(distance, from, to), limits, distance, from, to, input);
      }
    }
  }

  @Test
  void fallsToItsSpeedLimitFirstWhenItBeginsTooFast() {
    Profile profile = ProfileLimits.of(1, 2).between(5, 2, 0);
    assertEquals(1, profile.speed(0.5), 1e-12);
    assertEquals(0.5 + (5 - 0.75 - 0.25) + 0.5, profile.durationS(), 1e-12);
  }

  @Test
  void stopsInTimeByWhateverItTakesWhenItBeginsTooFastForTheWay() {
    Profile profile = new ProfileLimits(1, 2, 10).between(0.1, 1, 0);
    assertEquals(0.2, profile.durationS(), 1e-12);
    assertEquals(-5, profile.acceleration(0.1), 1e-12);
    assertEquals(0.1, profile.position(1), 0);
  }

  @Test
  void takesExactlyTheTimeGivenWithASpeedNoMoreThanTwiceTheMean() {
    for (int i = 0; i < CASES; i++) {
      ProfileLimits limits = anyLimits(i);
      double distance = between(1e-6, 6);
      double duration = between(0.01, 20);
      String input = distance + ", " + duration + ", " + limits;
      Profile profile = limits.withDuration(distance, duration);
      assertEquals(duration, profile.durationS(), 1e-9 * duration, input);
      double mean = distance / duration;
      assertTrue(profile.peakSpeed() >= mean * (1 - 1e-9), input);
      assertTrue(profile.peakSpeed() <= 2 * mean * (1 + 1e-9), input);
      double most = between(0, 1) * duration;
      assertTrue(profile.position(most) >= 0 && profile.position(most) <= distance, input);
    }
  }

  /** Distance is the integral of speed, speed that of acceleration, and limits hold. */
  private static void check(
      Profile profile,
      ProfileLimits limits,
      double distance,
      double from,
      double to,
      String input) {
    double end = profile.durationS();
    assertEquals(0, profile.position(0), 0, input);
    assertEquals(distance, profile.position(end), 0, input);
    assertEquals(from, profile.speed(0), 1e-12, input);
    assertEquals(to, profile.speed(end), 0, input);
    double step = end / 400;
    double a = limits.acceleration();
    for (int k = 0; k < 400; k++) {
      double begin = k * step;
      double next = begin + step;
      double covered = profile.position(next) - profile.position(begin);
      assertTrue(covered >= -1e-12, input);
      assertEquals(step * profile.speed(begin + step / 2), covered, a * step * step + 1e-9, input);
      double faster = profile.speed(next) - profile.speed(begin);
      assertTrue(Math.abs(faster) <= a * step * (1 + 1e-6) + 1e-9, input);
      assertTrue(profile.speed(next) <= Math.max(from, limits.speed()) * (1 + 1e-9), input);
      if (limits.jerk() < Double.POSITIVE_INFINITY && k > 0 && k < 399) {
        double change = profile.acceleration(next) - profile.acceleration(begin);
        assertTrue(Math.abs(change) <= limits.jerk() * step * (1 + 1e-6) + 1e-6 * a, input);
      }
    }
  }
}
