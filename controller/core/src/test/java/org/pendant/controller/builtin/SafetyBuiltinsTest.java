package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class SafetyBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private void within(boolean expected, Object... arguments) throws ScriptError {
    assertEquals(Value.of(expected), fixture.call("is_within_safety_limits", arguments));
  }

  @Test
  void jointPositionsAreComparedWithTheJointLimits() throws ScriptError {
    within(true, floats(BoxSetup.START_RAD.toArray()));
    within(true, floats(6.2, -1.57, -1.57, -1.57, 1.57, 0));
    within(false, floats(6.5, -1.57, -1.57, -1.57, 1.57, 0));
  }

  @Test
  void aPoseIsWithinTheLimitsIfItsJointPositionsAre() throws ScriptError {
    Value here = fixture.call("get_actual_tcp_pose");
    within(true, here);
    within(true, here, floats(BoxSetup.START_RAD.toArray()));
    within(false, pose(5, 5, 5, 0, 0, 0));
  }

  @Test
  void aPositionIsAPoseOrSixJoints() {
    refuses(
        "wrong-type",
        "position is list [1, 2, 3], must be a list of 6 numbers",
        () -> fixture.call("is_within_safety_limits", floats(1, 2, 3)));
    refuses(
        "value-out-of-range",
        "must be finite",
        () -> fixture.call("is_within_safety_limits", floats(0, 0, 0, 0, 0, Double.NaN)));
  }

  @Test
  void transitionsAreHardOrSoft() throws ScriptError {
    fixture.call("set_safety_mode_transition_hardness", 0);
    fixture.call("set_safety_mode_transition_hardness", 1);
    refuses(
        "value-out-of-range",
        "set_safety_mode_transition_hardness: type is 2, must be 0 to 1",
        () -> fixture.call("set_safety_mode_transition_hardness", 2));
  }

  @Test
  void deviationsAreSharesOfWhatStopsTheArm() throws ScriptError {
    fixture.call("position_deviation_warning", true);
    fixture.call("position_deviation_warning", false, 1);
    refuses(
        "value-out-of-range",
        "position_deviation_warning: threshold is 1.1, must be 0 to 1",
        () -> fixture.call("position_deviation_warning", true, 1.1));
    refuses(
        "value-out-of-range",
        "threshold is ",
        () -> fixture.call("position_deviation_warning", true, Double.NaN));
  }

  @Test
  void errorCodesAreInts() throws ScriptError {
    fixture.call("pause_on_error_code", 173, 3);
    fixture.call("pause_on_error_code", 173);
    refuses(
        "wrong-type",
        "pause_on_error_code: code is string C173",
        () -> fixture.call("pause_on_error_code", "C173"));
    refuses("wrong-type", "argument is", () -> fixture.call("pause_on_error_code", 173, 0.5));
  }

  @Test
  void holdingTorqueNeedsNoArguments() throws ScriptError {
    assertTrue(CallFixture.nothing(fixture.call("high_holding_torque_disable")));
    assertTrue(CallFixture.nothing(fixture.call("high_holding_torque_enable")));
  }
}
