package org.pendant.controller.encoder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;

final class EncoderTest {
  private static final Signal A = new Signal(SignalBank.STANDARD_IN, 0);
  private static final Signal B = new Signal(SignalBank.STANDARD_IN, 1);

  private final DigitalIo io = new DigitalIo();
  private final Encoders encoders = new Encoders();
  private final Encoder encoder = encoders.get(0);

  private void levels(boolean a, boolean b) {
    io.set(A.bank(), A.index(), a);
    io.set(B.bank(), B.index(), b);
    encoders.step(io);
  }

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      encoders.step(io);
    }
  }

  private int after(PulseDecoder.Kind kind, boolean... levelsOfA) {
    encoder.decode(new PulseDecoder(kind, A, B), io);
    for (boolean level : levelsOfA) {
      levels(level, false);
    }
    return encoder.rawCount();
  }

  @Test
  void countsEachEdgeOfAQuadratureSignalInItsDirection() {
    encoder.decode(new PulseDecoder(PulseDecoder.Kind.QUADRATURE, A, B), io);
    for (int period = 0; period < 3; period++) {
      levels(true, false);
      levels(true, true);
      levels(false, true);
      levels(false, false);
    }
    assertEquals(12, encoder.rawCount());
    for (int period = 0; period < 5; period++) {
      levels(false, true);
      levels(true, true);
      levels(true, false);
      levels(false, false);
    }
    assertEquals(-8, encoder.rawCount());
  }

  @Test
  void aQuadratureSignalOfWhichBothInputsChangeAtOnceCountsNothing() {
    encoder.decode(new PulseDecoder(PulseDecoder.Kind.QUADRATURE, A, B), io);
    levels(true, true);
    levels(false, false);
    assertEquals(0, encoder.rawCount());
  }

  @Test
  void countsBothEdgesOfOneInput() {
    assertEquals(3, after(PulseDecoder.Kind.BOTH_EDGES, true, false, false, true));
  }

  @Test
  void countsRisingEdgesOfOneInput() {
    assertEquals(2, after(PulseDecoder.Kind.RISING_EDGE, true, true, false, true));
  }

  @Test
  void countsFallingEdgesOfOneInput() {
    assertEquals(1, after(PulseDecoder.Kind.FALLING_EDGE, true, false, false, true));
  }

  @Test
  void anInputThatIsHighWhenDecodingBeginsIsNoEdge() {
    io.set(A.bank(), A.index(), true);
    encoder.decode(new PulseDecoder(PulseDecoder.Kind.RISING_EDGE, A, B), io);
    frames(5);
    assertEquals(0, encoder.rawCount());
  }

  @Test
  void countsNothingBeforeItIsSetUpAndAfterItIsDisabled() {
    levels(true, false);
    levels(false, false);
    assertEquals(0, encoder.rawCount());
    assertEquals(2, after(PulseDecoder.Kind.BOTH_EDGES, true, false));
    encoder.disable();
    levels(true, false);
    assertEquals(2, encoder.rawCount());
  }

  @Test
  void theFirstCountThatIsToldIsTakenAtOnce() {
    encoder.expectCounts(CountRange.UNSIGNED_16);
    encoder.tell(50_000);
    assertEquals(50_000, encoder.rawCount());
    assertEquals(50_000, encoder.filteredCount());
  }

  @Test
  void laterCountsAreFollowedSmoothlyAndReached() {
    encoder.expectCounts(CountRange.UNSIGNED_16);
    encoder.tell(100);
    frames(1);
    encoder.tell(110);
    frames(1);
    double soon = encoder.filteredCount();
    assertTrue(soon > 100 && soon < 110, () -> "after a frame " + soon);
    frames(1000);
    assertEquals(110, encoder.filteredCount(), 1e-6);
  }

  @Test
  void aCountThatWrapsHasGoneOnTheShorterWay() {
    for (CountRange range : CountRange.values()) {
      encoder.expectCounts(range);
      encoder.tell(range.highest() - 2);
      double before = encoder.filteredTotal();
      encoder.tell(range.lowest() + 3);
      frames(1000);
      assertEquals(6, encoder.filteredTotal() - before, 1e-5, range.toString());
      assertEquals((int) (range.lowest() + 3), encoder.rawCount(), range.toString());
      encoder.tell(range.highest());
      frames(1000);
      assertEquals(2, encoder.filteredTotal() - before, 1e-5, range.toString());
    }
  }

  @Test
  void randomWaysThroughAllWrapsAreSummedUpExactly() {
    long seed = 11;
    SplittableRandom random = new SplittableRandom(seed);
    for (CountRange range : CountRange.values()) {
      encoder.expectCounts(range);
      long place = range.lowest() + random.nextLong(range.size());
      encoder.tell(place);
      double start = encoder.filteredTotal();
      long way = 0;
      for (int i = 0; i < 500; i++) {
        long step = random.nextLong(-range.size() / 2 + 1, range.size() / 2);
        way += step;
        encoder.tell(range.wrapped(place + way));
      }
      frames(2000);
      double tolerance = 1e-6 + 1e-9 * Math.abs(way);
      assertEquals(
          (double) way, encoder.filteredTotal() - start, tolerance, range + ", seed " + seed);
    }
  }

  @Test
  void theFilteredCountWrapsAt65536() {
    encoder.run(500);
    encoders.get(1).run(-500);
    frames(65_536 + 7);
    assertEquals(7, encoder.filteredCount(), 1e-3);
    assertEquals(65_543, encoder.rawCount());
    assertEquals(65_536 - 7, encoders.get(1).filteredCount(), 1e-3);
    assertEquals(-65_543, encoders.get(1).rawCount());
  }

  @Test
  void theRawCountWrapsAt32Bits() {
    encoder.expectCounts(CountRange.UNSIGNED_32);
    encoder.tell(0x8000_0000L);
    assertEquals(Integer.MIN_VALUE, encoder.rawCount());
    encoder.tell(0xFFFF_FFFFL);
    assertEquals(-1, encoder.rawCount());
  }

  @Test
  void aBeltOfEvenSpeedIsFollowedWithoutLag() {
    for (double ticksPerS : new double[] {500, 5000, 1234.5, 100, -730}) {
      Encoders both = new Encoders();
      both.get(0).run(ticksPerS);
      for (int frame = 1; frame <= 2000; frame++) {
        both.step(io);
        double exact = ticksPerS * frame * 0.002;
        double off = both.get(0).filteredTotal() - exact;
        int frameNow = frame;
        // a count is the tick below: half a tick on the average, and a whole one at the most
        assertTrue(
            frame < 500 || Math.abs(off) <= 1.2,
            () -> ticksPerS + " ticks/s, frame " + frameNow + ": off by " + off);
      }
    }
  }

  @Test
  void coarseTicksAreInterpolated() {
    encoder.run(125);
    frames(2000);
    double before = encoder.filteredTotal();
    for (int i = 0; i < 500; i++) {
      encoders.step(io);
      double step = encoder.filteredTotal() - before;
      assertEquals(0.25, step, 0.02);
      before = encoder.filteredTotal();
    }
  }

  @Test
  void aBeltDoesNotCountDownWhereTheDecoderCannotTellDirections() {
    encoder.decode(new PulseDecoder(PulseDecoder.Kind.RISING_EDGE, A, B), io);
    encoder.run(-1000);
    frames(100);
    assertEquals(200, encoder.rawCount());
  }

  @Test
  void aBeltDoesNotChangeCountsThatAProgramTells() {
    encoder.expectCounts(CountRange.SIGNED_32);
    encoder.tell(7);
    encoder.run(1000);
    frames(100);
    assertEquals(7, encoder.rawCount());
  }

  @Test
  void unwindsWhatIsMoreThanHalfTheRange() {
    assertEquals(Optional.empty(), encoder.unwound(3));
    encoder.expectCounts(CountRange.UNSIGNED_16);
    assertEquals(Optional.of(870.0), encoder.unwound(-64_666));
    assertEquals(Optional.of(-870.0), encoder.unwound(64_666));
    assertEquals(Optional.of(32_768.0), encoder.unwound(32_768));
    encoder.expectCounts(CountRange.UNSIGNED_8);
    assertEquals(Optional.of(-55.5), encoder.unwound(200.5));
    encoder.expectCounts(CountRange.SIGNED_32);
    assertEquals(Optional.of(-4.0), encoder.unwound(4_294_967_292.0));
  }

  @Test
  void thereAreTwo() {
    assertThrows(IllegalArgumentException.class, () -> encoders.get(2));
    encoder.run(1000);
    frames(10);
    assertFalse(encoders.get(1).enabled());
    assertEquals(0, encoders.get(1).rawCount());
  }

  @Test
  void refusesABeltThatIsTooFast() {
    assertThrows(IllegalArgumentException.class, () -> encoder.run(2e6));
    assertThrows(IllegalArgumentException.class, () -> encoder.run(Double.NaN));
  }
}
