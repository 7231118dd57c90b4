package org.pendant.motion.force;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;

final class ContactWatchTest {
  private static final double[] EVERYWHERE = {0, 0, 0};

  private final ContactWatch watch = new ContactWatch();

  private void feel(double fx, double fy, double fz) {
    watch.add(WrenchNumbers.of(new Wrench(fx, fy, fz, 0, 0, 0)));
  }

  private void feelNothing(int frames) {
    for (int i = 0; i < frames; i++) {
      feel(0, 0, 0);
    }
  }

  private int onset(double... direction) {
    return watch.framesSinceOnset(direction, 5);
  }

  @Test
  void nothingHasBeenFeltAtFirst() {
    assertEquals(0, onset(EVERYWHERE));
    feel(100, 0, 0);
    assertEquals(0, onset(EVERYWHERE));
  }

  @Test
  void answersTheFramesBackToJustBeforeTheForceRose() {
    feelNothing(10);
    feel(0, 0, 1);
    feel(0, 0, 3);
    assertEquals(0, onset(EVERYWHERE));
    feel(0, 0, 6);
    assertEquals(3, onset(EVERYWHERE));
    feel(0, 0, 7);
    assertEquals(4, onset(EVERYWHERE));
  }

  @Test
  void onlyWhatPushesBackAgainstADirectionCounts() {
    feelNothing(10);
    feel(0, 0, 20);
    assertEquals(1, onset(0, 0, -0.1));
    assertEquals(0, onset(0, 0, 0.1));
    assertEquals(0, onset(1, 0, 0));
    // 20 N at 80 degrees to the direction are 3.5 N along it
    assertEquals(0, onset(Math.sin(1.4), 0, -Math.cos(1.4)));
  }

  @Test
  void theThresholdCanBeHigherOrLower() {
    feelNothing(10);
    feel(3, 0, 0);
    assertEquals(0, watch.framesSinceOnset(EVERYWHERE, 3.1));
    assertEquals(1, watch.framesSinceOnset(EVERYWHERE, 2.9));
  }

  @Test
  void aForceThatWasThereBeforeIsNoContact() {
    for (int i = 0; i < 100; i++) {
      feel(50, 0, 0);
    }
    assertEquals(0, onset(EVERYWHERE));
    feel(56, 0, 0);
    assertEquals(1, onset(EVERYWHERE));
  }

  @Test
  void aForceThatStaysLongEnoughIsNoContactAnyMore() {
    feelNothing(10);
    for (int i = 0; i < 30_000; i++) {
      feel(20, 0, 0);
    }
    assertEquals(0, onset(EVERYWHERE));
  }

  @Test
  void whatIsLeftOfOneContactIsNotTakenForTheNext() {
    feelNothing(10);
    for (int i = 0; i < 500; i++) {
      feel(0, 0, 20);
    }
    feelNothing(300);
    assertEquals(0, onset(EVERYWHERE));
    for (int i = 1; i <= 10; i++) {
      feel(0, 0, 2 * i);
    }
    // the mean is 1 N or so too high: the first frame of the new contact is not seen
    assertEquals(9, onset(EVERYWHERE), 1);
  }

  @Test
  void looksBackNoFartherThanPositionsAreKept() {
    feelNothing(10);
    for (int i = 0; i < 1500; i++) {
      feel(0, 0, 20);
    }
    assertEquals(ContactWatch.FRAMES - 1, onset(EVERYWHERE));
  }

  @Test
  void whatWasBeforeAnotherZeroDoesNotCount() {
    feelNothing(10);
    feel(0, 0, 20);
    watch.forget();
    assertEquals(0, onset(EVERYWHERE));
    feel(0, 0, 3);
    assertEquals(0, onset(EVERYWHERE));
    feel(0, 0, 9);
    assertEquals(1, onset(EVERYWHERE));
  }
}
