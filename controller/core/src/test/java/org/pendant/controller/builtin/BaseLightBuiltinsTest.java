package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BaseLight;
import org.pendant.controller.message.LogEntry;
import org.pendant.script.value.ScriptError;

class BaseLightBuiltinsTest {
  @Test
  void theLightShowsWhatItIsTold() throws ScriptError {
    CallFixture fixture = new CallFixture("ur20");
    fixture.call("set_baselight_off");
    assertEquals(BaseLight.OFF, fixture.box().arm().baseLight());
    fixture.call("set_baselight_solid", 0, 128, 255);
    assertEquals(new BaseLight.Solid(0, 128, 255), fixture.box().arm().baseLight());
    fixture.call("set_baselight_iec");
    assertEquals(BaseLight.STANDARD, fixture.box().arm().baseLight());
    assertEquals(List.of(), fixture.box().log().since(0));
  }

  @Test
  void armsWithoutALightSaySoOnce() throws ScriptError {
    CallFixture fixture = new CallFixture("ur5e");
    fixture.call("set_baselight_off");
    fixture.call("set_baselight_solid", 255, 0, 0);
    assertEquals(BaseLight.STANDARD, fixture.box().arm().baseLight());
    assertEquals(
        List.of("ur5e has no light in its base, only arms of the UR-Series do"),
        fixture.box().log().since(0).stream().map(LogEntry::text).toList());
  }

  @Test
  void coloursHaveEightBits() {
    CallFixture fixture = new CallFixture("ur20");
    refuses(
        "value-out-of-range",
        "set_baselight_solid: g is 256, must be 0 to 255",
        () -> fixture.call("set_baselight_solid", 0, 256, 0));
    refuses("value-out-of-range", "b is -1", () -> fixture.call("set_baselight_solid", 0, 0, -1));
  }
}
