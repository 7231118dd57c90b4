package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;

import org.junit.jupiter.api.Test;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class VectorBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private double[] numbers(String name, Object... arguments) throws ScriptError {
    NumberList list = (NumberList) fixture.call(name, arguments);
    double[] numbers = new double[list.length()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = list.numberAt(i);
    }
    return numbers;
  }

  @Test
  void theNormOfANumberIsItsMagnitude() throws ScriptError {
    assertEquals(Value.of(5.3), fixture.call("norm", -5.3));
    assertEquals(Value.of(8), fixture.call("norm", -8));
    refuses("value-out-of-range", "-2147483648", () -> fixture.call("norm", Integer.MIN_VALUE));
  }

  @Test
  void theNormOfAListOrPoseIsItsLength() throws ScriptError {
    Value ofPose = fixture.call("norm", pose(-.2, .2, -.2, -1.57, 0, 3.14));
    assertEquals(3.52768, ((FloatValue) ofPose).value(), 1e-5);
    assertEquals(Value.of(5.0), fixture.call("norm", ints(3, 4)));
    assertEquals(Value.of(0.0), fixture.call("norm", ints()));
    refuses("wrong-type", "a is string", () -> fixture.call("norm", "x"));
    refuses("wrong-type", "a is list", () -> fixture.call("norm", bools(true)));
    refuses("wrong-type", "a is list", () -> fixture.call("norm", strings("a")));
  }

  @Test
  void normalizingKeepsTheDirection() throws ScriptError {
    assertEquals(floats(1, 0, 0), fixture.call("normalize", ints(1, 0, 0)));
    assertEquals(floats(0, 1, 0), fixture.call("normalize", ints(0, 5, 0)));
    double half = Math.sqrt(0.5);
    assertArrayEquals(new double[] {0, half, half}, numbers("normalize", ints(0, 1, 1)), 1e-15);
  }

  @Test
  void nothingCannotBeNormalized() {
    refuses(
        "value-out-of-range",
        "normalize: v is [0, 0, 0]",
        () -> fixture.call("normalize", floats(0, 0, 0)));
    refuses("value-out-of-range", "v is []", () -> fixture.call("normalize", ints()));
    refuses("wrong-type", "v is int", () -> fixture.call("normalize", 3));
  }

  @Test
  void normalizingLeavesTheArgumentAlone() throws ScriptError {
    NumberList v = floats(0, 2);
    fixture.call("normalize", v);
    assertEquals(floats(0, 2), v);
  }

  @Test
  void rotationVectorsAndRollPitchYawConvert() throws ScriptError {
    assertArrayEquals(
        new double[] {-2.80856, -0.16202, 0.9}, numbers("rotvec2rpy", floats(3.14, 1.57, 0)), 1e-4);
    assertArrayEquals(
        new double[] {2.22153, 0.00177, -2.21976},
        numbers("rpy2rotvec", floats(3.14, 1.57, 0)),
        1e-5);
    refuses("wrong-type", "3 numbers", () -> fixture.call("rotvec2rpy", ints(1, 2)));
    refuses("wrong-type", "3 numbers", () -> fixture.call("rpy2rotvec", ints(1, 2, 3, 4)));
  }

  @Test
  void aWrenchIsSeenFromAnotherFrame() throws ScriptError {
    // a force along z at the flange turns about a point 0.1 m aside
    assertArrayEquals(
        new double[] {0, 0, 10, 0, 1, 0},
        numbers("wrench_trans", pose(0.1, 0, 0, 0, 0, 0), ints(0, 0, 10, 0, 0, 0)),
        1e-12);
    refuses(
        "wrong-type",
        "w_from",
        () -> fixture.call("wrench_trans", pose(0, 0, 0, 0, 0, 0), ints(1, 2, 3)));
    refuses(
        "wrong-type",
        "T_from_to",
        () -> fixture.call("wrench_trans", ints(1), ints(0, 0, 10, 0, 0, 0)));
  }
}
