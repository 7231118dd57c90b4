package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class ArgumentsTest {
  private static final Option SPEED = new Option("--speed", "N", "how fast");
  private static final Option INPUT = new Option("--input", "NAME=LEVEL", "a level");
  private static final Option QUIET = new Option("--quiet", "", "say less");

  private static Arguments parse(String... words) throws UsageException {
    return Arguments.parse(List.of(SPEED, INPUT, QUIET), List.of(words));
  }

  private static String refusal(String... words) {
    return assertThrows(UsageException.class, () -> parse(words)).getMessage();
  }

  @Test
  void valuesFollowTheNameOrAnEqualsSign() throws UsageException {
    assertEquals(Optional.of("2"), parse("--speed", "2").value(SPEED));
    assertEquals(Optional.of("2"), parse("--speed=2").value(SPEED));
    assertEquals(Optional.of(""), parse("--speed=").value(SPEED));
    assertEquals(Optional.empty(), parse("a").value(SPEED));
  }

  @Test
  void onlyTheFirstEqualsSignSeparates() throws UsageException {
    assertEquals(List.of("in[0]=true"), parse("--input=in[0]=true").values(INPUT));
  }

  @Test
  void optionsMayStandAnywhereAndRepeat() throws UsageException {
    Arguments arguments = parse("a", "--input", "x=1", "b", "--quiet", "--input", "y=0", "c");

    assertEquals(List.of("a", "b", "c"), arguments.operands());
    assertEquals(List.of("x=1", "y=0"), arguments.values(INPUT));
    assertTrue(arguments.has(QUIET));
    assertFalse(arguments.has(SPEED));
  }

  @Test
  void everythingAfterTwoDashesIsAnOperand() throws UsageException {
    assertEquals(List.of("a", "--speed", "-x"), parse("a", "--", "--speed", "-x").operands());
  }

  @Test
  void mistakesAreNamed() throws UsageException {
    assertEquals("unknown option --sped, did you mean --speed?", refusal("--sped", "1"));
    assertEquals("--speed needs a value: --speed N", refusal("--speed"));
    assertEquals("--quiet takes no value, it was given --quiet=1", refusal("--quiet=1"));
    Arguments twice = parse("--speed", "1", "--speed", "2");
    assertEquals(
        "--speed is given 2 times, expected once",
        assertThrows(UsageException.class, () -> twice.value(SPEED)).getMessage());
  }
}
