package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceState;

final class DeviceRowTest {
  private static String doing(DeviceState device) {
    return DeviceRow.of(device).doing();
  }

  @Test
  void fingersTellHowFarTheyAreOpenAndWhatTheyHold() {
    assertEquals(
        "85.0 mm open",
        doing(new DeviceState("g", "gripper", 0.085, 0.085, 0, false, 0.085, 0, 0)));
    assertEquals(
        "30.0 mm, holds a part with 235 N",
        doing(new DeviceState("g", "gripper", 0.085, 0.03, 235, true, 0.085, 0.03, 0)));
  }

  @Test
  void aDoorTellsHowFarItIsOpen() {
    assertEquals("25 % open", doing(new DeviceState("d", "door", 1, 0.25, 0, false, 0, 0, 0)));
    assertEquals("Closed", doing(new DeviceState("d", "door", 1, 0, 0, false, 0, 0, 0)));
    assertEquals("Open", doing(new DeviceState("d", "door", 1, 1, 0, false, 0, 0, 0)));
  }

  @Test
  void aRailTellsWhereItsObjectIs() {
    assertEquals(
        "At 120.5 of 200.0 mm", doing(new DeviceState("r", "rail", 0.2, 0.1205, 0, true, 0, 0, 0)));
  }

  @Test
  void whatHasNoFingersTellsWhatItSeesOrHolds() {
    assertEquals(
        "Holds a part", doing(new DeviceState("v", "vacuum gripper", 0, 0, 0, true, 1, 1, 0)));
    assertEquals("Sees a part", doing(new DeviceState("c", "camera", 0, 0, 0, true, 0, 0, 50_100)));
    assertEquals("Sees nothing", doing(new DeviceState("s", "sensor", 0, 0, 0, false, 0, 0, 0)));
  }

  @Test
  void beltsTellWhetherTheyRun() {
    assertEquals("Runs", doing(new DeviceState("b", "belt", 0, 0, 0, true, 0, 0, 0)));
    assertEquals("Stands still", doing(new DeviceState("b", "belt", 0, 0, 0, false, 0, 0, 0)));
  }

  @Test
  void switchesTellWhetherTheyArePressedAndLampsWhetherTheyAreLit() {
    DeviceState button = new DeviceState("b", "button", 0, 0, 0, true, 1, 1, 0);
    assertEquals("Pressed", doing(button));
    assertEquals(DeviceRow.Box.PRESS, DeviceRow.of(button).box());
    assertTrue(DeviceRow.of(button).boxOn());
    assertEquals(
        "Not pressed", doing(new DeviceState("l", "limit switch", 0, 0, 0, false, 1, 0, 0)));
    assertEquals("Lit", doing(new DeviceState("r", "lamp", 0, 0, 0, true, 0, 0, 0)));
    assertEquals("Not lit", doing(new DeviceState("r", "lamp", 0, 0, 0, false, 0, 0, 0)));
  }
}
