package org.pendant.controller.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.value.Make.bools;
import static org.pendant.controller.value.Make.floats;
import static org.pendant.controller.value.Make.ints;
import static org.pendant.controller.value.Make.list;
import static org.pendant.controller.value.Make.matrix;
import static org.pendant.controller.value.Make.pose;
import static org.pendant.controller.value.Make.strings;
import static org.pendant.controller.value.Make.struct;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ValueTextTest {

  @Test
  void floatsHaveSixDecimalsWithoutTrailingZeros() {
    assertEquals("4", ValueText.number(4.0));
    assertEquals("2.123456", ValueText.number(2.123456123456));
    assertEquals("0.000025", ValueText.number(0.000025));
    assertEquals("-1.25", ValueText.number(-1.25));
    assertEquals("100000", ValueText.number(1e5));
    assertEquals("1", ValueText.number(0.9999999));
    assertEquals("10000000000", ValueText.number(1e10));
    assertEquals("123456789012.125", ValueText.number(123456789012.125));
  }

  @Test
  void theSignOfZeroIsNotShown() {
    assertEquals("0", ValueText.number(-0.0));
    assertEquals("0", ValueText.number(-4e-7));
    assertEquals("0", ValueText.number(-Double.MIN_VALUE));
    assertEquals("-0.000001", ValueText.number(-6e-7));
  }

  @Test
  void infinitiesAndNotANumberHaveNames() {
    assertEquals("inf", ValueText.number(Double.POSITIVE_INFINITY));
    assertEquals("-inf", ValueText.number(Double.NEGATIVE_INFINITY));
    assertEquals("nan", ValueText.number(Double.NaN));
  }

  @Test
  void roundingIsThatOfTheExactBinaryValue() {
    // 0.0000005 is a little below its decimal, 0.0000015 too; 2^-7 = 0.0078125 is a true tie
    assertEquals(exact(0.0000005), ValueText.number(0.0000005));
    assertEquals(exact(0.0000015), ValueText.number(0.0000015));
    assertEquals("0.007812", ValueText.number(0.0078125));
    assertEquals("0.023438", ValueText.number(0.0234375));
  }

  @Test
  void manyFloatsPrintAsTheirExactDecimalRounded() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 100_000; i++) {
      double number =
          switch (i % 4) {
            case 0 -> random.nextDouble(-10, 10);
            case 1 -> random.nextInt(-2_000_000, 2_000_000) / 2e6;
            case 2 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(-60, 60));
            default -> random.nextInt(-1000, 1000) / 128.0 + random.nextInt(1000);
          };
      assertEquals(exact(number), ValueText.number(number), () -> "number " + number);
    }
  }

  private static String exact(double number) {
    BigDecimal rounded = new BigDecimal(number).setScale(6, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  @Test
  void everyKindOfValueHasItsText() throws ScriptError {
    assertEquals("None", NoneValue.NONE.text());
    assertEquals("True", Value.of(true).text());
    assertEquals("-12", Value.of(-12).text());
    assertEquals("as \"it\" is", Value.of("as \"it\" is").text());
    assertEquals("p[1, 2, 3, 4, 5, 6]", pose(1, 2, 3, 4, 5, 6).text());
    assertEquals("[1, 2, 3]", ints(1, 2, 3).text());
    assertEquals("[0.5, 1]", floats(0.5, 1).text());
    assertEquals("[True, False]", bools(true, false).text());
    assertEquals("[]", ints().text());
    assertEquals("[\"a\", \"b\"]", strings("a", "b").text());
    assertEquals("[p[0, 0, 0, 0, 0, 1]]", list(pose(0, 0, 0, 0, 0, 1)).text());
    assertEquals("[[1, 2], [3, 4]]", matrix(ints(1, 2), ints(3, 4)).text());
    assertEquals("{a = 1, b = \"x\"}", struct("a", 1, "b", "x").text());
    assertEquals("{in = {n = 0.5}}", struct("in", struct("n", 0.5)).text());
  }

  @Test
  void textThatIsTooLongKeepsItsClosingBracket() {
    assertEquals("[1, 2, 3]", ValueText.shortened(ints(1, 2, 3), 9));
    assertEquals("[1, ...]", ValueText.shortened(ints(1, 2, 3), 8));
    assertEquals("{a =...}", ValueText.shortened(struct("a", 123456), 8));
  }
}
