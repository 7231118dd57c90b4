package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Ray;

final class DragPlaneTest {
  private static final Vector3 DOWN = new Vector3(0, 0, -1);

  @Test
  void aRayMeetsThePlaneWhereItGoesThrough() {
    assertEquals(
        Optional.of(new Vector3(1, 2, 0.5)),
        new DragPlane(new Vector3(9, 9, 0.5), new Vector3(0, 0, 3))
            .meet(new Ray(new Vector3(1, 2, 4), DOWN)));
  }

  @Test
  void whatIsBehindTheEyeOrSeenFromTheEdgeIsNotMet() {
    DragPlane floor = new DragPlane(new Vector3(0, 0, 0), new Vector3(0, 0, 1));
    assertEquals(Optional.empty(), floor.meet(new Ray(new Vector3(0, 0, -1), DOWN)));
    assertEquals(Optional.empty(), floor.meet(new Ray(new Vector3(0, 0, 1), new Vector3(1, 0, 0))));
    DragPlane none = new DragPlane(new Vector3(0, 0, 0), new Vector3(0, 0, 0));
    assertEquals(Optional.empty(), none.meet(new Ray(new Vector3(0, 0, 1), DOWN)));
  }
}
