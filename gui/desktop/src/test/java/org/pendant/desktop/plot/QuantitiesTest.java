package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.pose.Pose;

final class QuantitiesTest {

  @Test
  void everyQuantityCanBeReadFromASnapshot() {
    RecordedArm arm = new RecordedArm();
    arm.frames(1);
    for (Quantity each : Quantities.standard().all()) {
      double value = each.value().applyAsDouble(arm.controller().state());
      assertTrue(Double.isFinite(value), each.id() + " is " + value);
    }
  }

  @Test
  void everyWordOfASearchMustFit() {
    List<Quantity> found = Quantities.standard().search("speed ELBOW");
    assertEquals(List.of("target_qd_2", "actual_qd_2"), found.stream().map(Quantity::id).toList());
    assertEquals(Quantities.standard().all().size(), Quantities.standard().search(" ").size());
  }

  @Test
  void anIdIsTakenOnce() {
    Quantities all = Quantities.standard();
    Quantity again = new Quantity("payload", "", "", "", "", state -> 0);
    assertEquals(
        "quantity payload is there already",
        assertThrows(IllegalArgumentException.class, () -> all.add(again)).getMessage());
  }

  @Test
  void theSpeedOfTheTcpIsTheChangeOfItsPlace() {
    RecordedArm arm = new RecordedArm();
    arm.run("def go():\n  movej([0.5, -1.2, -1.4, -1.0, 1.0, 0.7], a=2, v=1)\nend\n");
    arm.frames(200);
    ControllerState before = arm.controller().state();
    arm.frames(2);
    TcpSpeed speed = TcpSpeed.of(arm.controller().state().arm());
    Pose from = before.arm().actualTcpInBase();
    Pose to = arm.controller().state().arm().actualTcpInBase();
    double seconds = arm.controller().state().timeS() - before.timeS();
    assertTrue(speed.mPerS() > 0.01, "the arm should move: " + speed);
    assertEquals((to.x() - from.x()) / seconds, speed.xMPerS(), 0.02);
    assertEquals((to.y() - from.y()) / seconds, speed.yMPerS(), 0.02);
    assertEquals((to.z() - from.z()) / seconds, speed.zMPerS(), 0.02);
  }

  @Test
  void peoplesNamesOfSignalsAreShownAndFound() {
    Quantities all =
        Quantities.standard(
            id -> id.equals("digital-in-0") || id.equals("input-float-register-3") ? "Grip" : "");
    assertEquals(
        List.of("Grip (digital_in[0])", "Grip (input_float_register[3])"),
        all.search("grip").stream().map(Quantity::namedLabel).toList());
    assertEquals("digital_in[1]", all.find("digital_in_1").orElseThrow().namedTitle());
  }
}
