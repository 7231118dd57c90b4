package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.session.SceneDraft;

final class PlacingHandTest {
  private final SceneDraft draft = new SceneDraft();
  private final List<String> chosen = new ArrayList<>();
  private final PlacingHand hand = new PlacingHand(draft, () -> true, chosen::add);

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
    assertTrue(hand.begin("ball"));
    assertEquals(List.of("ball"), chosen);
    hand.move(new Vector3(0.1234, 0, 0), false);
    assertEquals(new Vector3(0.52, 0.033, 0.05), placeM(), "it keeps what it does not change");
    hand.move(new Vector3(0.1234, 0.001, 0), true);
    assertEquals(new Vector3(0.523, 0.034, 0.05), placeM());
  }

  @Test
  void aDragIsUndoneAsOneChange() {
    put();
    assertTrue(hand.begin("ball"));
    hand.move(new Vector3(0.1, 0, 0), false);
    hand.move(new Vector3(0.2, 0, 0), false);
    hand.end();
    assertTrue(hand.begin("ball"));
    hand.move(new Vector3(0, 0, 0.1), false);
    hand.end();
    draft.undo();
    assertEquals(new Vector3(0.6, 0.033, 0.05), placeM());
    draft.undo();
    assertEquals(new Vector3(0.4, 0.033, 0.05), placeM());
  }

  @Test
  void aPlaneIsNoThingToDrag() {
    put();
    assertFalse(hand.begin("table"));
    assertFalse(hand.begin("nothing"));
  }

  @Test
  void nothingIsDraggedOutOfTheSpaceThatThereIs() {
    put();
    assertTrue(hand.begin("ball"));
    hand.move(new Vector3(20, 0, 0), false);
    assertEquals(new Vector3(0.4, 0.033, 0.05), placeM());
  }
}
