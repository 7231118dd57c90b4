package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceState;
import org.pendant.desktop.unit.DisplayUnit;

final class DeviceRowTest {
  private static String doing(DeviceState device) {
    return doing(device, DisplayUnit.MILLIMETRE);
  }

  private static String doing(DeviceState device, DisplayUnit length) {
    return DeviceRow.of(device, length).doing();
  }

  @Test
  void fingersTellHowFarTheyAreOpenAndWhatTheyHold() {
    assertEquals(
        "85.00 mm open",
        doing(new DeviceState("g", "gripper", 0.085, 0.085, 0, false, 0.085, 0, 0)));
    assertEquals(
        "30.00 mm, holds a part with 235 N",
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
        "At 120.50 of 200.00 mm",
        doing(new DeviceState("r", "rail", 0.2, 0.1205, 0, true, 0, 0, 0)));
  }

  @Test
  void lengthsAreToldInTheUnitThatPeopleRead() {
    DeviceState rail = new DeviceState("r", "rail", 0.508, 0.127, 0, true, 0, 0, 0);

    assertEquals("At 5.0000 of 20.0000 in", doing(rail, DisplayUnit.INCH));
    assertEquals("At 0.12700 of 0.50800 m", doing(rail, DisplayUnit.METRE));
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
    assertEquals(DeviceRow.Box.PRESS, DeviceRow.of(button, DisplayUnit.MILLIMETRE).box());
    assertTrue(DeviceRow.of(button, DisplayUnit.MILLIMETRE).boxOn());
    assertEquals(
        "Not pressed", doing(new DeviceState("l", "limit switch", 0, 0, 0, false, 1, 0, 0)));
    assertEquals("Lit", doing(new DeviceState("r", "lamp", 0, 0, 0, true, 0, 0, 0)));
    assertEquals("Not lit", doing(new DeviceState("r", "lamp", 0, 0, 0, false, 0, 0, 0)));
  }
}
