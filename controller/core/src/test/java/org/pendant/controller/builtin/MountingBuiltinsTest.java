package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;

import org.junit.jupiter.api.Test;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;

class MountingBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private String text(String name) throws ScriptError {
    return fixture.call(name).text();
  }

  private double accelerometerZ() throws ScriptError {
    return ((NumberList) fixture.call("get_tool_accelerometer_reading")).numberAt(2);
  }

  @Test
  void atFirstTheBaseStandsUprightAndStill() throws ScriptError {
    assertEquals("[0, 0, 9.82]", text("get_gravity"));
    assertEquals("[0, 0, 0]", text("get_base_acceleration"));
  }

  @Test
  void gravityIsWhatIsSet() throws ScriptError {
    fixture.call("set_gravity", floats(0, 9.82, 0));
    assertEquals("[0, 9.82, 0]", text("get_gravity"));
    assertEquals(0, accelerometerZ(), 1e-9);
  }

  @Test
  void theBasesAccelerationIsFeltBesideGravity() throws ScriptError {
    fixture.call("set_base_acceleration", floats(0.1, 0, 1));
    assertEquals("[0.1, 0, 1]", text("get_base_acceleration"));
    assertEquals("[0, 0, 9.82]", text("get_gravity"));
    assertEquals(-10.82, accelerometerZ(), 1e-9);
  }

  @Test
  void accelerationsAreThreeModestNumbers() {
    refuses(
        "value-out-of-range",
        "set_gravity: d is [0, 0, 982], each must be -100 to 100 m/s\u00b2",
        () -> fixture.call("set_gravity", floats(0, 0, 982)));
    refuses(
        "value-out-of-range",
        "set_base_acceleration: a is [nan, 0, 0], each must be",
        () -> fixture.call("set_base_acceleration", floats(Double.NaN, 0, 0)));
    refuses(
        "wrong-type",
        "must be a list of 3 numbers",
        () -> fixture.call("set_gravity", floats(0, 9.82)));
  }
}
