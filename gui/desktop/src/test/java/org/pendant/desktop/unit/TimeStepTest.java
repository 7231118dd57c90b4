package org.pendant.desktop.unit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class TimeStepTest {
  @ParameterizedTest
  @CsvSource({
    "0.0001, 0.002",
    "0.003, 0.005",
    "0.1, 0.1",
    "1.2, 2",
    "2.1, 5",
    "5.1, 10",
    "60, 100"
  })
  void isTheNextRoundNumberAndAtLeastAFrame(double leastS, double stepS) {
    assertEquals(stepS, TimeStep.atLeast(leastS), 1e-12);
  }
}
