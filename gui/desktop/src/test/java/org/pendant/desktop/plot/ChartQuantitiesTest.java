package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.pose.Pose;

final class ChartQuantitiesTest {

  @Test
  void everyQuantityCanBeReadFromASnapshot() {
    RecordedArm arm = new RecordedArm();
    arm.frames(1);
    for (ChartQuantity each : ChartQuantities.standard().all()) {
      double value = each.value().applyAsDouble(arm.controller().state());
      // there is no object around that it could be far from
      boolean nothing = each.id().equals("object_distance");
      assertEquals(nothing, Double.isNaN(value), each.id() + " is " + value);
      assertFalse(Double.isInfinite(value), each.id() + " is " + value);
    }
  }

  @Test
  void everyWordOfASearchMustFit() {
    List<ChartQuantity> found = ChartQuantities.standard().search("speed ELBOW");
    assertEquals(
        List.of("target_qd_2", "actual_qd_2", "elbow_speed_x", "elbow_speed_y", "elbow_speed_z"),
        found.stream().map(ChartQuantity::id).toList());
    assertEquals(
        ChartQuantities.standard().all().size(), ChartQuantities.standard().search(" ").size());
  }

  @Test
  void aQuantityIsFoundByItsNameInRtdeToo() {
    assertEquals(
        List.of("tcp_force_x", "tcp_force_y", "tcp_force_z", "tcp_torque_x", "tcp_torque_y"),
        ChartQuantities.standard().search("actual_TCP_force").stream()
            .map(ChartQuantity::id)
            .limit(5)
            .toList());
  }

  @Test
  void aLegendSaysWhatStandsInTheGroup() {
    assertEquals("Target speed, elbow", label("target_qd_2"));
    assertEquals("TCP actual pose, rx", label("actual_tcp_rx"));
    assertEquals("Elbow position, z", label("elbow_z"));
    assertEquals("Payload", label("payload"));
    assertEquals("digital_in[3]", label("digital_in_3"));
  }

  private static String label(String id) {
    return ChartQuantities.standard().find(id).orElseThrow().label();
  }

  @Test
  void anIdIsTakenOnce() {
    ChartQuantities all = ChartQuantities.standard();
    ChartQuantity again = new ChartQuantity("payload", "", "", "", "", state -> 0);
    assertEquals(
        "quantity payload is there already",
        assertThrows(IllegalArgumentException.class, () -> all.add(again)).getMessage());
  }

  private static double value(RecordedArm arm, String id) {
    ChartQuantity quantity = ChartQuantities.standard().find(id).orElseThrow();
    return quantity.value().applyAsDouble(arm.controller().state());
  }

  @Test
  void theSpeedOfTheTcpIsTheChangeOfItsPlace() {
    RecordedArm arm = new RecordedArm();
    arm.run("def go():\n  movej([0.5, -1.2, -1.4, -1.0, 1.0, 0.7], a=2, v=1)\nend\n");
    arm.frames(200);
    ControllerState before = arm.controller().state();
    arm.frames(2);
    Pose from = before.arm().actualTcpInBase();
    Pose to = arm.controller().state().arm().actualTcpInBase();
    double seconds = arm.controller().state().timeS() - before.timeS();
    assertTrue(value(arm, "tcp_speed") > 10, "the arm should move");
    assertEquals(1e3 * (to.x() - from.x()) / seconds, value(arm, "tcp_speed_x"), 20);
    assertEquals(1e3 * (to.y() - from.y()) / seconds, value(arm, "tcp_speed_y"), 20);
    assertEquals(1e3 * (to.z() - from.z()) / seconds, value(arm, "tcp_speed_z"), 20);
  }

  @Test
  void peoplesNamesOfSignalsAreShownAndFound() {
    ChartQuantities all =
        ChartQuantities.standard(
            id -> id.equals("digital-in-0") || id.equals("input-float-register-3") ? "Grip" : "");
    assertEquals(
        List.of("Grip (digital_in[0])", "Grip (input_float_register[3])"),
        all.search("grip").stream().map(ChartQuantity::namedLabel).toList());
    assertEquals("digital_in[1]", all.find("digital_in_1").orElseThrow().namedTitle());
  }
}
