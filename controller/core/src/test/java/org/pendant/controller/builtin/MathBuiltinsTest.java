package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.ints;

import org.junit.jupiter.api.Test;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class MathBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private double number(String name, Object... arguments) throws ScriptError {
    return ((FloatValue) fixture.call(name, arguments)).value();
  }

  private void domain(String part, String name, Object... arguments) {
    refuses("value-out-of-range", part, () -> fixture.call(name, arguments));
  }

  @Test
  void anglesComeFromTheirFunctions() throws ScriptError {
    assertEquals(0.785, number("acos", 0.707), 1e-3);
    assertEquals(Math.PI, number("acos", -1));
    assertEquals(0.785, number("asin", 0.707), 1e-3);
    assertEquals(Math.PI / 4, number("atan", 1.0));
    assertEquals(Math.PI / 4, number("atan2", 0.5, 0.5));
    assertEquals(Math.PI / 2, number("atan2", 1, 0));
    assertEquals(-3 * Math.PI / 4, number("atan2", -1, -1), 1e-15);
  }

  @Test
  void arcsOutsideMinusOneToOneAreErrors() {
    domain("acos: f is 1.000001, must be -1 to 1", "acos", 1.000001);
    domain("f is -2", "acos", -2);
    domain("nan", "acos", Double.NaN);
    domain("asin: f is 1.5", "asin", 1.5);
  }

  @Test
  void trigonometryTakesRadians() throws ScriptError {
    assertEquals(0.0, number("cos", Math.PI / 2), 1e-15);
    assertEquals(1.0, number("sin", 1.57), 1e-6);
    assertEquals(1.0, number("tan", 0.7854), 1e-5);
    assertEquals(1.0, number("cos", 0));
  }

  @Test
  void degreesAndRadiansConvert() throws ScriptError {
    assertEquals(Math.PI / 2, number("d2r", 90));
    assertEquals(90.0, number("r2d", Math.PI / 2));
    assertEquals(89.954373, number("r2d", 1.57), 1e-6);
  }

  @Test
  void roundingAnswersInts() throws ScriptError {
    assertEquals(Value.of(2), fixture.call("ceil", 1.43));
    assertEquals(Value.of(-1), fixture.call("ceil", -1.5));
    assertEquals(Value.of(1), fixture.call("floor", 1.53));
    assertEquals(Value.of(-2), fixture.call("floor", -1.5));
    assertEquals(Value.of(0), fixture.call("ceil", -0.5));
    assertEquals(Value.of(7), fixture.call("floor", 7));
    assertEquals(Value.of(Integer.MAX_VALUE), fixture.call("floor", 2147483647.9));
    domain("floor: f is 2147483648", "floor", 2147483648.0);
    domain("f is nan", "ceil", Double.NaN);
    domain("f is -inf", "ceil", Double.NEGATIVE_INFINITY);
  }

  @Test
  void logarithmsHaveABase() throws ScriptError {
    assertEquals(0.60206, number("log", 10.0, 4.0), 1e-5);
    assertEquals(3.0, number("log", 10, 1000));
    assertEquals(-2.0, number("log", 2, 0.25));
    assertEquals(Double.NEGATIVE_INFINITY, number("log", 10, 0));
    domain("b is -2", "log", -2, 4);
    domain("f is -4", "log", 2, -4);
    domain("b is 1", "log", 1.0, 4);
  }

  @Test
  void powersAreFloats() throws ScriptError {
    assertEquals(Value.of(125.0), fixture.call("pow", 5.0, 3));
    assertEquals(-8.0, number("pow", -2, 3));
    assertEquals(0.25, number("pow", -2, -2.0));
    assertEquals(1.0, number("pow", 0, 0));
    domain("pow: exponent is 0.5", "pow", -2, 0.5);
    domain("pow: exponent is -1", "pow", 0, -1);
  }

  @Test
  void rootsOfNegativeNumbersAreErrors() throws ScriptError {
    assertEquals(Value.of(3.0), fixture.call("sqrt", 9));
    domain("sqrt: f is -1, must not be negative", "sqrt", -1);
  }

  @Test
  void argumentsOfOtherKindsAreRefused() {
    refuses("wrong-type", "sin: f is string x, must be a number", () -> fixture.call("sin", "x"));
    refuses("wrong-type", "f is bool True", () -> fixture.call("sqrt", true));
    refuses("wrong-type", "f is list [1, 2]", () -> fixture.call("cos", ints(1, 2)));
  }

  @Test
  void randomNumbersFollowFromTheSeed() throws ScriptError {
    CallFixture same = new CallFixture();
    for (int i = 0; i < 100; i++) {
      double first = number("random");
      assertTrue(first >= 0 && first < 1, () -> "random is " + first);
      assertEquals(Value.of(first), same.call("random"));
    }
  }
}
