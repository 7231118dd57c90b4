package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;

final class EquipmentTest {
  @Test
  void everyKindHasADeviceToBeginWith() {
    for (DeviceKind kind : DeviceKind.ALL) {
      DeviceText fresh = DeviceForm.fresh(kind, List.of(), Scene.EMPTY);
      String refusal = Equipment.refusal(Scene.EMPTY, Equipment.with(Map.of(), List.of(fresh)));
      // belts and sources need an object first
      assertTrue(refusal.isEmpty() || refusal.startsWith("object is \"none\""), refusal);
    }
  }

  @Test
  void devicesKeepWhatTheFileSaysOfThem() {
    String written =
        "[\n    {\"type\": \"rg\", \"name\": \"left\", \"part\": 0.03,"
            + " \"fingers\": {\"at\": [0, 0, 0.1, 0, 0, 0], \"friction\": 1}}\n  ]";
    assertEquals(written, DeviceText.write(DeviceText.read(written)));
  }

  @Test
  void namesOfNewDevicesDiffer() {
    DeviceKind door = DeviceKind.of("door").orElseThrow();
    DeviceText first = DeviceForm.fresh(door, List.of(), Scene.EMPTY);
    DeviceText second = DeviceForm.fresh(door, List.of(first), Scene.EMPTY);
    assertEquals("door_2", second.name());
    assertEquals("digital_out[1]", second.text("close"));
  }

  @Test
  void newCamerasHavePortsOfTheirOwn() {
    DeviceKind camera = DeviceKind.of("camera").orElseThrow();
    DeviceText first = DeviceForm.fresh(camera, List.of(), Scene.EMPTY);
    DeviceText second = DeviceForm.fresh(camera, List.of(first), Scene.EMPTY);
    DeviceText third = DeviceForm.fresh(camera, List.of(first, second), Scene.EMPTY);
    assertEquals(
        "",
        Equipment.refusal(Scene.EMPTY, Equipment.with(Map.of(), List.of(first, second, third))));
  }

  @Test
  void namesOfObjectsAreKeptAsAList() {
    DeviceText camera = DeviceText.read("[{\"type\": \"camera\"}]").getFirst();
    DeviceText knows = camera.withList("objects", List.of("block", "disc"));
    assertEquals(List.of("block", "disc"), knows.list("objects"));
    assertEquals(camera, knows.withList("objects", List.of()));
  }

  @Test
  void rulesThatPressASwitchFollowItsName() {
    DeviceKind button = DeviceKind.of("button").orElseThrow();
    DeviceText start = DeviceForm.fresh(button, List.of(), Scene.EMPTY);
    Map<String, String> cell =
        Equipment.with(
            Equipment.with(Map.of(), List.of(start)), "[{\"every\": 5, \"press\": \"button\"}]");
    assertEquals(
        "[{\"every\": 5, \"press\": \"go\"}]",
        Equipment.rules(Equipment.with(cell, List.of(start.named("go")))));
  }

  @Test
  void camerasFollowTheNamesOfTheirObjects() {
    DeviceText camera =
        DeviceForm.fresh(DeviceKind.of("camera").orElseThrow(), List.of(), Scene.EMPTY)
            .withList("objects", List.of("block", "disc"));
    Map<String, String> cell = Equipment.with(Map.of(), List.of(camera));
    Map<String, String> next =
        Equipment.following(cell, List.of(plane("block")), List.of(plane("cube")));
    assertEquals(List.of("cube", "disc"), Equipment.devices(next).getFirst().list("objects"));
  }

  private static SceneObject plane(String name) {
    return new SceneObject.Plane(
        name, new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT);
  }
}
