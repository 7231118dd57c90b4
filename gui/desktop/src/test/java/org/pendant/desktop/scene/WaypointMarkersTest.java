package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.WaypointMarkers.Mark;
import org.pendant.desktop.scene.WaypointMarkers.Stop;
import org.pendant.models.pose.Pose;

final class WaypointMarkersTest {
  private static Mark mark(String name) {
    return new Mark(name, Pose.ZERO, false, 0);
  }

  /** A, B, A again; the node with the key {@code chosen} is looked at. */
  private static WaypointMarkers markers(long chosen) {
    return new WaypointMarkers(
        List.of(mark("A"), mark("B"), mark("unused")),
        List.of(List.of(stop(0, 3, chosen), stop(1, 4, chosen), stop(0, 5, chosen))));
  }

  private static Stop stop(int mark, long node, long chosen) {
    return new Stop(mark, node, "MoveL", node == chosen);
  }

  private static Optional<Long> node(Optional<Stop> stop) {
    return stop.map(Stop::node);
  }

  @Test
  void aPlaceThatSeveralNodesGoToLeadsToOneAfterTheOther() {
    assertEquals(Optional.of(3L), node(markers(0).next(0)));
    assertEquals(Optional.of(5L), node(markers(3).next(0)));
    assertEquals(Optional.of(3L), node(markers(5).next(0)));
    assertEquals(Optional.empty(), markers(0).next(2));
  }

  @Test
  void stopsAreGoneThroughInTheirOrder() {
    assertEquals(Optional.of(3L), node(markers(0).stepped(1)));
    assertEquals(Optional.of(5L), node(markers(0).stepped(-1)));
    assertEquals(Optional.of(4L), node(markers(3).stepped(1)));
    assertEquals(Optional.of(5L), node(markers(3).stepped(-1)));
    assertEquals(Optional.empty(), WaypointMarkers.NONE.stepped(1));
  }
}
