package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class ContactBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  @BeforeEach
  void somethingPushesUpInTheLastFrame() {
    for (int i = 0; i < 10; i++) {
      fixture.box().flange().contactWatch().add(WrenchNumbers.of(Wrench.ZERO));
    }
    fixture.box().flange().contactWatch().add(WrenchNumbers.of(new Wrench(0, 0, 10, 0, 0, 0)));
  }

  @Test
  void theStepsAreAnInt() throws ScriptError {
    assertEquals(Value.of(1), fixture.call("tool_contact"));
  }

  @Test
  void theDirectionIsAListOrAPose() throws ScriptError {
    assertEquals(Value.of(1), fixture.call("tool_contact", floats(0, 0, -1, 9, 9, 9)));
    assertEquals(Value.of(0), fixture.call("tool_contact", floats(0, 0, 1, 9, 9, 9)));
    assertEquals(Value.of(1), fixture.call("tool_contact", pose(0, 0, -0.1, 0, 0, 0)));
  }

  @Test
  void aThresholdOfZeroIsTheUsualOne() throws ScriptError {
    assertEquals(Value.of(1), fixture.call("tool_contact", floats(0, 0, 0, 0, 0, 0), 0));
    assertEquals(Value.of(0), fixture.call("tool_contact", floats(0, 0, 0, 0, 0, 0), 10.5));
  }

  @Test
  void refusesOtherArguments() {
    refuses("wrong-type", "direction is", () -> fixture.call("tool_contact", floats(0, 0, 1)));
    refuses(
        "value-out-of-range",
        "direction is",
        () -> fixture.call("tool_contact", floats(0, Double.NaN, 1, 0, 0, 0)));
    refuses(
        "value-out-of-range",
        "force_threshold is -1 N, must not be negative",
        () -> fixture.call("tool_contact", floats(0, 0, 1, 0, 0, 0), -1));
  }
}
