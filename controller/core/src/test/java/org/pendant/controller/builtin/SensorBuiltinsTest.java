package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;

import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;

class SensorBuiltinsTest {
  private static final double WEIGHT_N = 2 * 9.82;

  private final CallFixture fixture = new CallFixture();

  private double number(String name, Object... arguments) throws ScriptError {
    return ((FloatValue) fixture.call(name, arguments)).value();
  }

  private void tcpForce(double... expected) throws ScriptError {
    double[] found = ((PoseValue) fixture.call("get_tcp_force")).pose().toArray();
    assertArrayEquals(expected, found, 1e-9);
  }

  @Test
  void aLoadThatNobodyDeclaredPullsDown() throws ScriptError {
    tcpForce(0, 0, 0, 0, 0, 0);
    fixture.box().flange().attachLoad(Payload.of(2, 0, 0, 0.1));
    // the tool points down: the weight pulls through the flange's middle
    tcpForce(0, 0, -WEIGHT_N, 0, 0, 0);
    assertEquals(WEIGHT_N, number("force"), 1e-9);
  }

  @Test
  void theRightPayloadIsNoForce() throws Exception {
    fixture.box().flange().attachLoad(Payload.of(2, 0, 0, 0.1));
    fixture.call("set_target_payload", 2, floats(0, 0, 0.1));
    fixture.box().drive().jumpTo(new Joints(0.3, -1, 1, 0.4, 0.5, 0.6));
    tcpForce(0, 0, 0, 0, 0, 0);
    assertEquals(0, number("force"), 1e-9);
  }

  @Test
  void zeroingHidesWhatIsThereNow() throws ScriptError {
    fixture.box().flange().attachLoad(Payload.of(2, 0, 0, 0.1));
    fixture.call("zero_ftsensor");
    assertEquals(0, number("force"), 1e-9);
    fixture.box().flange().attachLoad(Payload.of(3, 0, 0, 0.1));
    assertEquals(WEIGHT_N / 2, number("force"), 1e-9);
  }

  @Test
  void declaringAPayloadZeroes() throws ScriptError {
    fixture.box().flange().attachLoad(Payload.of(2, 0, 0, 0.1));
    fixture.call("set_target_payload", 1, floats(0, 0, 0.1));
    tcpForce(0, 0, 0, 0, 0, 0);
  }

  @Test
  void anAccelerometerThatPointsDownReadsMinusGravity() throws ScriptError {
    NumberList reading = (NumberList) fixture.call("get_tool_accelerometer_reading");
    assertEquals(3, reading.length());
    assertEquals(0, reading.numberAt(0), 1e-9);
    assertEquals(0, reading.numberAt(1), 1e-9);
    assertEquals(-9.82, reading.numberAt(2), 1e-9);
  }

  @Test
  void thePositionsOfPastFramesAreKept() throws Exception {
    Joints there = new Joints(0, -1, -1, -1, 1, 0);
    NumberList start = floats(BoxSetup.START_RAD.toArray());
    NumberList goal = floats(there.toArray());
    fixture.box().drive().jumpTo(there);
    assertEquals(goal, fixture.call("get_actual_joint_positions_history"));
    assertEquals(start, fixture.call("get_actual_joint_positions_history", 1));
    for (int frame = 0; frame < 999; frame++) {
      fixture.box().drive().step();
    }
    assertEquals(goal, fixture.call("get_actual_joint_positions_history", 998));
    assertEquals(start, fixture.call("get_actual_joint_positions_history", 999));
  }

  @Test
  void onlyAThousandFramesAreKept() {
    refuses(
        "value-out-of-range",
        "get_actual_joint_positions_history: steps is 1000, must be 0 to 999",
        () -> fixture.call("get_actual_joint_positions_history", 1000));
    refuses(
        "value-out-of-range",
        "steps is -1",
        () -> fixture.call("get_actual_joint_positions_history", -1));
  }

  @Test
  void temperaturesAreThoseOfARoomAtFirst() throws ScriptError {
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      assertEquals(25, number("get_joint_temp", joint), 1);
    }
    assertEquals(25, number("get_tool_temp"), 1);
    assertEquals(25, number("get_controller_temp"), 1);
  }

  @Test
  void thereAreSixJoints() {
    refuses(
        "value-out-of-range",
        "get_joint_temp: j is 6, must be 0 to 5",
        () -> fixture.call("get_joint_temp", 6));
  }

  @Test
  void theToolTakesCurrentWhileTheArmHasPower() throws ScriptError {
    assertEquals(0.08, number("get_tool_current"));
    fixture.box().safety().powerOff();
    assertEquals(0, number("get_tool_current"));
  }

  @Test
  void aRestingArmFeelsAndDoesNothing() throws ScriptError {
    assertEquals("[0, 0, 0, 0, 0, 0]", fixture.call("get_actual_joint_accelerations").text());
    assertEquals("[0, 0, 0, 0, 0, 0]", fixture.call("get_joint_torques").text());
  }
}
