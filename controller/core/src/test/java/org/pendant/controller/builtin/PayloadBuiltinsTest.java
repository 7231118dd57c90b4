package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

class PayloadBuiltinsTest {
  private static final NumberList COG = floats(0.01, -0.02, 0.1);
  private static final NumberList INERTIA = floats(0.02, 0.03, 0.04, 0.001, -0.002, 0.003);

  private final CallFixture fixture = new CallFixture();

  private String text(String name, Object... arguments) throws ScriptError {
    return fixture.call(name, arguments).text();
  }

  private void declared(String mass, String cog, String inertia) throws ScriptError {
    assertEquals(mass, text("get_target_payload"));
    assertEquals(cog, text("get_target_payload_cog"));
    assertEquals(inertia, text("get_target_payload_inertia"));
  }

  private void refusesInertia(String part, double... inertia) {
    refuses(
        "value-out-of-range",
        part,
        () -> fixture.call("set_target_payload", 1, COG, floats(inertia)));
  }

  @Test
  void aNewControllerKnowsNoPayload() throws ScriptError {
    declared("0", "[0, 0, 0]", "[0, 0, 0, 0, 0, 0]");
  }

  @Test
  void aDeclaredPayloadIsReadBack() throws ScriptError {
    fixture.call("set_target_payload", 1.5, COG, INERTIA);
    declared("1.5", "[0.01, -0.02, 0.1]", "[0.02, 0.03, 0.04, 0.001, -0.002, 0.003]");
  }

  @Test
  void aPayloadUnderWayIsReadAsIfItHeld() throws ScriptError {
    fixture.call("set_target_payload", 2, COG, INERTIA, 1);
    assertEquals("2", text("get_target_payload"));
    assertEquals(0, fixture.box().arm().model().payload().massKg());
  }

  @Test
  void theOldFunctionsForgetTheInertia() throws ScriptError {
    fixture.call("set_target_payload", 1.5, COG, INERTIA);
    fixture.call("set_payload_mass", 2);
    declared("2", "[0.01, -0.02, 0.1]", "[0, 0, 0, 0, 0, 0]");
    fixture.call("set_target_payload", 1.5, COG, INERTIA);
    fixture.call("set_payload_cog", floats(0, 0, 0.05));
    declared("1.5", "[0, 0, 0.05]", "[0, 0, 0, 0, 0, 0]");
    fixture.call("set_target_payload", 1.5, COG, INERTIA);
    fixture.call("set_payload", 3, floats(0, 0, 0.3));
    declared("3", "[0, 0, 0.3]", "[0, 0, 0, 0, 0, 0]");
  }

  @Test
  void withoutACentreOfGravityThePayloadStaysAtTheTcp() throws ScriptError {
    fixture.call("set_tcp", pose(0, 0, 0.1, 0, 0, 0));
    fixture.call("set_payload", 1);
    declared("1", "[0, 0, 0.1]", "[0, 0, 0, 0, 0, 0]");
    fixture.call("set_tcp", pose(0, 0.05, 0.2, 0, 0, 0));
    declared("1", "[0, 0.05, 0.2]", "[0, 0, 0, 0, 0, 0]");
    fixture.call("set_payload_mass", 2);
    fixture.call("set_tcp", pose(0, 0, 0, 0, 0, 0));
    declared("2", "[0, 0.05, 0.2]", "[0, 0, 0, 0, 0, 0]");
  }

  @Test
  void massesThatNoArmHoldsAreRefused() {
    String expected = "must be 0 to 20 kg, 4 times what ur5e is made for";
    refuses(
        "value-out-of-range",
        "set_target_payload: m is -1 kg, " + expected,
        () -> fixture.call("set_target_payload", -1, COG));
    refuses(
        "value-out-of-range",
        "set_payload: m is 500 kg, " + expected,
        () -> fixture.call("set_payload", 500));
    refuses(
        "value-out-of-range",
        "set_payload_mass: m is ",
        () -> fixture.call("set_payload_mass", Double.NaN));
  }

  @Test
  void aMassBeyondTheRatedPayloadIsTakenWithAWarning() throws ScriptError {
    fixture.call("set_payload", 5, COG);
    assertEquals(List.of(), fixture.box().log().since(0));
    fixture.call("set_payload", 6, COG);
    fixture.call("set_payload", 6, COG);
    assertEquals(
        List.of("the payload is 6 kg, ur5e is made for 5 kg"),
        fixture.box().log().since(0).stream().map(LogEntry::text).toList());
    assertEquals("6", text("get_target_payload"));
  }

  @Test
  void centresOfGravityFarAwayAreRefused() {
    refuses(
        "value-out-of-range",
        "set_payload: cog is [0, 0, 9], each must be -4 to 4 m",
        () -> fixture.call("set_payload", 1, floats(0, 0, 9)));
    refuses(
        "value-out-of-range",
        "CoG is [0, 0, inf], each must be",
        () -> fixture.call("set_payload_cog", floats(0, 0, Double.POSITIVE_INFINITY)));
    refuses(
        "wrong-type",
        "must be a list of 3 numbers",
        () -> fixture.call("set_target_payload", 1, floats(0, 0)));
  }

  @Test
  void inertiasThatNoBodyHasAreRefused() throws ScriptError {
    refusesInertia("each must be -133 to 133 kg m\u00b2", 134, 0, 0, 0, 0, 0);
    refusesInertia("each must be -133 to 133 kg m\u00b2", 0, 0, 0, 0, 0, -134);
    refusesInertia("the first three must not be negative", 1, -1, 1, 0, 0, 0);
    refusesInertia("no body has it", 1, 1, 1, 1.1, 0, 0);
    refusesInertia("no body has it", 0, 1, 1, 0, 0.1, 0);
    refusesInertia("no body has it", 1, 1, 1, 0, 0, 1.1);
    refusesInertia("no body has it", 1, 1, 1, -0.9, 0.9, 0.9);
    fixture.call("set_target_payload", 1, COG, floats(133, 133, 133, 133, 133, 133));
  }

  @Test
  void transitionsCannotTakeNegativeTime() {
    refuses(
        "value-out-of-range",
        "set_target_payload: transition_time is -1 s, must not be negative",
        () -> fixture.call("set_target_payload", 1, COG, INERTIA, -1));
  }

  @Test
  void aPayloadIsEstimatedFromWhatTheSensorReadInFourPoses() throws Exception {
    fixture.call("set_tcp", pose(0.02, 0, 0.15, 0.3, 0, 0.2));
    fixture.box().flange().attachLoad(Payload.of(1.8, 0.02, -0.01, 0.07));
    fixture.call("zero_ftsensor");
    List<Value> poses = new ArrayList<>();
    List<Value> wrenches = new ArrayList<>();
    for (double tilt : new double[] {-1.6, -1, -0.4, 0.3}) {
      fixture.box().drive().jumpTo(new Joints(0, -1.57, -1.57, tilt, 1.57 + tilt, tilt));
      poses.add(fixture.call("get_actual_tcp_pose"));
      wrenches.add(fixture.call("get_tcp_force"));
    }
    Value estimate =
        fixture.call("estimate_payload", list(poses.toArray()), list(wrenches.toArray()));
    StructValue found = (StructValue) estimate;
    assertEquals(List.of("mass", "cog"), found.names());
    assertEquals(1.8, ((FloatValue) found.get("mass")).value(), 1e-6);
    NumberList cog = (NumberList) found.get("cog");
    assertEquals(0.02, cog.numberAt(0), 1e-6);
    assertEquals(-0.01, cog.numberAt(1), 1e-6);
    assertEquals(0.07, cog.numberAt(2), 1e-6);
    double[] rows =
        wrenches.stream()
            .flatMapToDouble(each -> Arrays.stream(((PoseValue) each).pose().toArray()))
            .toArray();
    Value matrix = MatrixValue.owning(wrenches.size(), 6, rows, false);
    assertEquals(estimate, fixture.call("estimate_payload", list(poses.toArray()), matrix));
  }

  @Test
  void anEstimateNeedsListsOfPoses() throws ScriptError {
    Value none = floats();
    Value four = list(pose(0, 0, 0, 0, 0, 0), pose(0, 0, 0, 1, 0, 0));
    refuses(
        "no-estimate",
        "estimate_payload: there are 0 poses, must be 4 to 500",
        () -> fixture.call("estimate_payload", none, none));
    refuses(
        "no-estimate",
        "there are 2 poses and 0 wrenches",
        () -> fixture.call("estimate_payload", four, none));
    refuses(
        "wrong-type",
        "poses is list [1, 2], must be a list of poses",
        () -> fixture.call("estimate_payload", floats(1, 2), none));
    Value endless = list(pose(0, 0, Double.NaN, 0, 0, 0));
    refuses(
        "value-out-of-range",
        "wrenches is ",
        () -> fixture.call("estimate_payload", none, endless));
    assertTrue(fixture.box().log().since(0).isEmpty());
  }
}
