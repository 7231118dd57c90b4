package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

final class PulseLengthTest {

  private static String refusal(String text) {
    return assertThrows(IllegalArgumentException.class, () -> PulseLength.parse(text)).getMessage();
  }

  @Test
  void pointAndCommaAreBothUnderstood() {
    assertEquals(new PulseLength(1.5), PulseLength.parse(" 1.5"));
    assertEquals(new PulseLength(1.5), PulseLength.parse("1,5 "));
  }

  @Test
  void whatIsNoNumberIsQuoted() {
    assertEquals("pulse is 'long', must be a number of seconds, 0.01 to 60", refusal("long"));
  }

  @Test
  void lengthsOutsideOfTheRangeAreRefused() {
    assertEquals("pulse is 0.0 s, must be 0.01 to 60 s", refusal("0"));
    assertEquals("pulse is 61.0 s, must be 0.01 to 60 s", refusal("61"));
    assertEquals("pulse is NaN s, must be 0.01 to 60 s", refusal("NaN"));
  }
}
