package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import org.junit.jupiter.api.Test;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class FreedriveBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private FreedriveMode mode() {
    return fixture.box().modes().freedrive().mode().orElseThrow();
  }

  @Test
  void withoutArgumentsEveryAxisIsFree() throws ScriptError {
    assertTrue(CallFixture.nothing(fixture.call("freedrive_mode")));
    assertEquals(FreeAxes.ALL, mode().axes());
    assertTrue(mode().payloadChecked());
  }

  @Test
  void axesAndFeatureAreTakenAsTheyAre() throws ScriptError {
    fixture.call("freedrive_mode", floats(1, 0, 0, 0, 0, 1), pose(0.1, 0, 0, 0, 0, 0.785));
    assertEquals(new FreeAxes(true, false, false, false, false, true), mode().axes());
    assertEquals(new FreedriveFrame.Feature(new Pose(0.1, 0, 0, 0, 0, 0.785)), mode().frame());
    fixture.call("freedrive_mode", floats(0, 1, 0, 0, 0, 0), "tool");
    assertEquals(FreedriveFrame.TOOL, mode().frame());
  }

  @Test
  void theUncheckedFormChecksNoPayload() throws ScriptError {
    fixture.call("freedrive_mode_no_incorrect_payload_check");
    assertFalse(mode().payloadChecked());
  }

  @Test
  void bothNamesEndIt() throws ScriptError {
    fixture.call("teach_mode");
    assertTrue(fixture.box().modes().freedrive().active());
    fixture.call("end_freedrive_mode");
    assertFalse(fixture.box().modes().freedrive().active());
    fixture.call("freedrive_mode");
    fixture.call("end_teach_mode");
    assertFalse(fixture.box().modes().freedrive().active());
  }

  @Test
  void theStatusIsAnInt() throws ScriptError {
    assertEquals(Value.of(0), fixture.call("get_freedrive_status"));
  }

  @Test
  void featuresMustBeFinite() {
    refuses(
        "value-out-of-range",
        "must be finite",
        () ->
            fixture.call(
                "freedrive_mode", floats(1, 1, 1, 1, 1, 1), pose(Double.NaN, 0, 0, 0, 0, 0)));
  }

  @Test
  void anArmWithoutPowerCannotBeGuided() {
    fixture.box().safety().powerOff();
    refuses(
        "freedrive-refused",
        "freedrive_mode: the arm is POWER_OFF, must be RUNNING",
        () -> fixture.call("freedrive_mode"));
  }
}
