package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

final class ReadingsTest {

  @Test
  void everyTitleHasAText() {
    ControllerState state = new Controller(ControllerOptions.headless()).state();
    assertEquals(Readings.OTHERS.size(), Readings.others(state).size());
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      assertEquals(Readings.JOINT_COLUMNS.size(), Readings.joint(state, joint).size());
    }
  }

  @Test
  void positionsAreInDegreesWithoutMinusZero() {
    Joints start = new Joints(-0.0001, -Math.PI / 2, -1.2, -1.5, 1.5, 0);
    ControllerState state = new Controller(ControllerOptions.headless().withStart(start)).state();
    assertEquals("0.0\u00b0", Readings.joint(state, 0).getFirst());
    assertEquals("-90.0\u00b0", Readings.joint(state, 1).getFirst());
  }

  @Test
  void whatHasAxesIsOneText() {
    ControllerState state = new Controller(ControllerOptions.headless()).state();
    assertEquals(
        "0.0, 0.0, 0.0 mm",
        Readings.others(state).get(Readings.OTHERS.indexOf("Centre of gravity")));
  }
}
