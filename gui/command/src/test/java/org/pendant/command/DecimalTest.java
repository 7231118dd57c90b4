package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class DecimalTest {

  @ParameterizedTest
  @CsvSource({
    "5.0, 2, 5",
    "12.5, 2, 12.5",
    "180.00000000000003, 1, 180",
    "1300, 0, 1300",
    "0.00002, 6, 0.00002",
    "-0.4255, 3, -0.426",
    "-0.0, 2, 0"
  })
  void numbersAreRoundedAndCarryNoIdleZeros(double value, int digits, String text) {
    assertEquals(text, Decimal.text(value, digits));
  }
}
