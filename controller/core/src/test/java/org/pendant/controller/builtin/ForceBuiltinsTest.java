package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import org.junit.jupiter.api.Test;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class ForceBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private Value start(Object type, Object selection, Object wrench, Object limits)
      throws ScriptError {
    return fixture.call("force_mode", pose(0, 0, 0, 0, 0, 0), selection, wrench, type, limits);
  }

  private void refusesStart(
      String code, String part, Object type, Object selection, Object wrench, Object limits) {
    refuses(code, part, () -> start(type, selection, wrench, limits));
    assertFalse(fixture.box().modes().forceMode().on());
  }

  private static Object axes() {
    return floats(0, 0, 1, 0, 0, 0);
  }

  private static Object six() {
    return floats(1, 1, 1, 1, 1, 1);
  }

  @Test
  void bothModesBeginAndBothEndsEndThem() throws ScriptError {
    assertTrue(CallFixture.nothing(start(2, axes(), six(), six())));
    assertTrue(fixture.box().modes().forceMode().on());
    assertTrue(CallFixture.nothing(fixture.call("end_force_mode")));
    assertFalse(fixture.box().modes().forceMode().on());
    assertTrue(CallFixture.nothing(fixture.call("screw_driving", 10, 0.1)));
    assertTrue(fixture.box().modes().forceMode().on());
    assertTrue(CallFixture.nothing(fixture.call("end_screw_driving")));
    assertFalse(fixture.box().modes().forceMode().on());
  }

  @Test
  void allThreeTypesAreKnownAndNoOthers() throws ScriptError {
    for (int type = 1; type <= 3; type++) {
      start(type, axes(), six(), six());
      fixture.call("end_force_mode");
    }
    refusesStart("value-out-of-range", "type is 0, must be 1 to 3", 0, axes(), six(), six());
    refusesStart("value-out-of-range", "type is 4, must be 1 to 3", 4, axes(), six(), six());
    refusesStart("wrong-type", "type is float 1.5", 1.5, axes(), six(), six());
  }

  @Test
  void anAxisIsCompliantOrNot() {
    refusesStart(
        "value-out-of-range",
        "each must be 0 (follows the path) or 1 (compliant)",
        2,
        floats(0, 0, 2, 0, 0, 0),
        six(),
        six());
  }

  @Test
  void allListsHaveSixNumbers() {
    Object five = floats(1, 1, 1, 1, 1);
    refusesStart("wrong-type", "selection_vector", 2, five, six(), six());
    refusesStart("wrong-type", "wrench", 2, axes(), five, six());
    refusesStart("wrong-type", "limits", 2, axes(), six(), five);
  }

  @Test
  void limitsMustNotBeNegativeAndWrenchesFinite() {
    refusesStart(
        "value-out-of-range", "none may be negative", 2, axes(), six(), floats(1, 1, -1, 1, 1, 1));
    refusesStart(
        "value-out-of-range",
        "must be finite",
        2,
        axes(),
        floats(0, 0, Double.NaN, 0, 0, 0),
        six());
  }

  @Test
  void typeOneNeedsTenMillimetresToItsPoint() throws ScriptError {
    var tcp = fixture.box().kinematics().targetTcpInBase();
    refuses(
        "value-out-of-range",
        "force_mode: the origin of task_frame is 0.0099",
        () ->
            fixture.call(
                "force_mode",
                pose(tcp.x() + 0.0099, tcp.y(), tcp.z(), 0, 0, 0),
                axes(),
                six(),
                1,
                six()));
    fixture.call(
        "force_mode", pose(tcp.x() + 0.0101, tcp.y(), tcp.z(), 0, 0, 0), axes(), six(), 1, six());
    assertTrue(fixture.box().modes().forceMode().on());
  }

  @Test
  void anArmInFreedriveIsRefused() throws ScriptError {
    fixture.call("freedrive_mode");
    refusesStart("freedrive", "the arm is in freedrive", 2, axes(), six(), six());
  }

  @Test
  void dampingAndGainKeepWhatTheyAreSetTo() throws ScriptError {
    assertEquals(Value.of(0.005), fixture.call("force_mode_get_damping"));
    assertEquals(Value.of(1.0), fixture.call("force_mode_get_gain_scaling"));
    fixture.call("force_mode_set_damping", 0.25);
    fixture.call("force_mode_set_gain_scaling", 2);
    assertEquals(Value.of(0.25), fixture.call("force_mode_get_damping"));
    assertEquals(Value.of(2.0), fixture.call("force_mode_get_gain_scaling"));
    fixture.box().programStarted();
    assertEquals(Value.of(0.005), fixture.call("force_mode_get_damping"));
  }

  @Test
  void dampingAndGainHaveRanges() {
    refuses(
        "value-out-of-range",
        "damping is 1.01, must be 0 to 1",
        () -> fixture.call("force_mode_set_damping", 1.01));
    refuses(
        "value-out-of-range", "must be 0 to 1", () -> fixture.call("force_mode_set_damping", -0.1));
    refuses(
        "value-out-of-range",
        "scaling is 2.1, must be 0 to 2",
        () -> fixture.call("force_mode_set_gain_scaling", 2.1));
  }

  @Test
  void screwDrivingNeedsASpeed() {
    refuses(
        "value-out-of-range",
        "v_limit is 0 m/s, must be above 0",
        () -> fixture.call("screw_driving", 10, 0));
    refuses(
        "value-out-of-range",
        "must be finite",
        () -> fixture.call("screw_driving", Double.NaN, 0.1));
  }
}
