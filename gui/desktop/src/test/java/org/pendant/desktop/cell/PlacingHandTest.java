package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.session.SceneDraft;

final class PlacingHandTest {
  private final SceneDraft draft = new SceneDraft();
  private final List<String> chosen = new ArrayList<>();
  private final PlacingHand hand =
      new PlacingHand(
          draft,
          () -> true,
          chosen::add,
          name -> chosen.add("device " + name),
          place -> "at " + place.x() + " " + place.y() + " " + place.z(),
          () -> chosen.add("put down"));

  private void put() {
    draft.set(
        new Scene(
            List.of(
                new SceneObject.Plane(
                    "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
                new SceneObject.Sphere(
                    "ball", new Vector3(0.4, 0.033, 0.05), 0.05, Material.DEFAULT)),
            Optional.empty(),
            List.of()));
  }

  private Vector3 placeM() {
    return ObjectShape.placeM(draft.scene().objects().getLast());
  }

  @Test
  void whatIsDraggedGoesInStepsWhereItGoes() {
    put();
    assertTrue(hand.begin("ball", new Vector3(0, 0, 0)));
    assertEquals(List.of("ball"), chosen);
    hand.move(new Vector3(0.1234, 0, 0), false);
    assertEquals(new Vector3(0.52, 0.033, 0.05), placeM(), "it keeps what it does not change");
    hand.move(new Vector3(0.1234, 0.001, 0), true);
    assertEquals(new Vector3(0.523, 0.034, 0.05), placeM());
  }

  @Test
  void aDragIsUndoneAsOneChange() {
    put();
    assertTrue(hand.begin("ball", new Vector3(0, 0, 0)));
    hand.move(new Vector3(0.1, 0, 0), false);
    hand.move(new Vector3(0.2, 0, 0), false);
    hand.end();
    assertTrue(hand.begin("ball", new Vector3(0, 0, 0)));
    hand.move(new Vector3(0, 0, 0.1), false);
    hand.end();
    draft.undo();
    assertEquals(new Vector3(0.6, 0.033, 0.05), placeM());
    draft.undo();
    assertEquals(new Vector3(0.4, 0.033, 0.05), placeM());
  }

  @Test
  void whatWasHeldIsPutDownOnce() {
    put();
    assertTrue(hand.begin("ball", new Vector3(0, 0, 0)));
    hand.end();
    assertFalse(hand.begin("table", new Vector3(0, 0, 0)));
    hand.end();
    assertEquals(List.of("ball", "put down"), chosen);
  }

  @Test
  void aPlaneIsNoThingToDrag() {
    put();
    assertFalse(hand.begin("table", new Vector3(0, 0, 0)));
    assertFalse(hand.begin("nothing", new Vector3(0, 0, 0)));
  }

  @Test
  void nothingIsDraggedOutOfTheSpaceThatThereIs() {
    put();
    assertTrue(hand.begin("ball", new Vector3(0, 0, 0)));
    hand.move(new Vector3(20, 0, 0), false);
    assertEquals(new Vector3(0.4, 0.033, 0.05), placeM());
  }

  private void putDevices() {
    draft.setEquipment(
        Map.of(
            Equipment.DEVICES,
            """
            [
              {"type": "light-barrier", "signal": "digital_in[0]", "from": [0.3, -0.25, 0.12], "to": [0.6, -0.25, 0.12]},
              {"type": "sink", "min": [0.1, 0.1, 0], "max": [0.3, 0.3, 0.2]}
            ]
            """));
  }

  private DeviceText device(int number) {
    return Equipment.devices(draft.equipment()).get(number);
  }

  private static DeviceHandles.Handle handle(String device, String key) {
    return new DeviceHandles.Handle(device, key, new Vector3(0, 0, 0));
  }

  @Test
  void anEndOfALightBarrierGoesByItself() {
    putDevices();
    assertTrue(hand.begin(handle("light-barrier", "to")));
    assertEquals(List.of("device light-barrier"), chosen);
    hand.move(new Vector3(0.104, 0.051, 0), false);
    assertEquals("at 0.7 -0.2 0.12", hand.words());
    hand.end();
    assertEquals(new Vector3(0.7, -0.2, 0.12), device(0).place("to"));
    assertEquals(new Vector3(0.3, -0.25, 0.12), device(0).place("from"));
    draft.undo();
    assertEquals(new Vector3(0.6, -0.25, 0.12), device(0).place("to"));
  }

  @Test
  void allOfADeviceGoesByItsMiddle() {
    putDevices();
    assertTrue(hand.begin(handle("light-barrier", DeviceHandles.WHOLE)));
    hand.move(new Vector3(0, 0, 0.1), false);
    assertEquals(new Vector3(0.3, -0.25, 0.22), device(0).place("from"));
    assertEquals(new Vector3(0.6, -0.25, 0.22), device(0).place("to"));
  }

  @Test
  void aCornerStopsAtTheOneAcross() {
    putDevices();
    assertTrue(hand.begin(handle("sink", "min")));
    hand.move(new Vector3(0.5, 0.05, 0), false);
    assertEquals(new Vector3(0.3, 0.15, 0), device(1).place("min"));
  }

  @Test
  void aDeviceStaysWhereThereIsNoRoomForIt() {
    putDevices();
    assertTrue(hand.begin(handle("sink", "max")));
    hand.move(new Vector3(20, 0, 0), false);
    assertEquals(new Vector3(0.3, 0.3, 0.2), device(1).place("max"));
    assertFalse(hand.begin(handle("nothing", "max")));
  }
}
