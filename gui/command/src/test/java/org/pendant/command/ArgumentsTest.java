package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

final class ArgumentsTest {
  private static final Option SPEED = Option.text("--speed", "N");
  private static final Option INPUT = Option.text("--input", "NAME=LEVEL").repeated();
  private static final Option QUIET = Option.flag("--quiet");

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

  @Test
  void numbersAreReadInTheRangeOfTheirOption() throws UsageException {
    Option time = Option.of("--time", new OptionArgument.Real("S", 0, 60, false, "seconds"));
    Option ports = Option.of("--ports", new OptionArgument.Whole("N", 1, 9)).standing("3");
    Option side = Option.of("--side", new OptionArgument.Choice("left", "right"));
    List<Option> options = List.of(time, ports, side);
    Arguments none = Arguments.parse(options, List.of());

    assertEquals(OptionalDouble.empty(), none.number(time));
    assertEquals(OptionalInt.of(3), none.whole(ports));
    assertEquals(Optional.empty(), none.word(side));
    Arguments right = Arguments.parse(options, List.of("--time=2.5", "--ports=9", "--side=left"));
    assertEquals(OptionalDouble.of(2.5), right.number(time));
    assertEquals(OptionalInt.of(9), right.whole(ports));
    assertEquals(Optional.of("left"), right.word(side));
    Arguments wrong = Arguments.parse(options, List.of("--time=NaN", "--ports=0", "--side=up"));
    assertEquals(
        "--time is NaN, must be 0 to 60 seconds",
        assertThrows(UsageException.class, () -> wrong.number(time)).getMessage());
    assertEquals(
        "--ports is 0, must be a number from 1 to 9",
        assertThrows(UsageException.class, () -> wrong.whole(ports)).getMessage());
    assertEquals(
        "--side is up, must be left or right",
        assertThrows(UsageException.class, () -> wrong.word(side)).getMessage());
  }
}
