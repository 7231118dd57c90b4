package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PacingTest {
  @ParameterizedTest
  @CsvSource({"500", "250", "125", "100", "1", "2.5", "333.3", "60", "499", "0.1e2"})
  void isDueSoOftenOnAverage(double frequencyHz) {
    Pacing pacing = new Pacing(frequencyHz);
    int due = 0;
    for (int frame = 0; frame < 500_000; frame++) {
      due += pacing.due() ? 1 : 0;
    }
    assertEquals(frequencyHz * 1000, due, 1);
  }

  @ParameterizedTest
  @CsvSource({"500", "300", "125", "1", "7.7"})
  void beginsAtOnceAndComesAsEvenlyAsFramesDo(double frequencyHz) {
    Pacing pacing = new Pacing(frequencyHz);
    assertTrue(pacing.due());
    int last = 0;
    for (int frame = 1; frame < 50_000; frame++) {
      if (pacing.due()) {
        double gap = frame - last;
        assertTrue(Math.abs(gap - 500 / frequencyHz) < 1, "a gap of " + gap + " frames");
        last = frame;
      }
    }
  }

  @Test
  void aQuarterOfTheFramesIsEveryFourth() {
    Pacing pacing = new Pacing(125);
    StringBuilder due = new StringBuilder();
    for (int frame = 0; frame < 12; frame++) {
      due.append(pacing.due() ? 'x' : '-');
    }
    assertEquals("x---x---x---", due.toString());
  }
}
