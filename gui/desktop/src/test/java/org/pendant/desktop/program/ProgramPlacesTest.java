package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.place;
import static org.pendant.desktop.program.Trees.waypoint;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep;

final class ProgramPlacesTest {
  /** Keys: move 2, A 3, B 4, A 5. */
  private final ProgramTree tree =
      Trees.of(move(waypoint("A"), waypoint("B"), waypoint("A"), waypoint("untaught")))
          .withWaypoint("A", place(1))
          .withWaypoint("B", place(2));

  private static List<List<Integer>> numbers(WaypointMarkers marks) {
    return marks.ways().stream()
        .map(way -> way.stream().map(WaypointMarkers.Stop::mark).toList())
        .toList();
  }

  @Test
  void eachPlaceIsMarkedOnceAndGoneToInOrder() {
    WaypointMarkers marks =
        ProgramPlaces.of(tree, Installation.NONE, Set.of(4L), PoseForm.STANDARD);
    assertEquals(
        List.of("A", "B"), marks.marks().stream().map(WaypointMarkers.Mark::name).toList());
    assertEquals(List.of(List.of(0, 1, 0)), numbers(marks));
    assertEquals(
        List.of(3L, 4L, 5L),
        marks.ways().getFirst().stream().map(WaypointMarkers.Stop::node).toList());
    assertTrue(marks.ways().getFirst().get(1).chosen());
    assertEquals(
        List.of(false, true), marks.marks().stream().map(WaypointMarkers.Mark::chosen).toList());
  }

  @Test
  void cornersOfAPatternLeadToThePattern() {
    ProgramTree pattern =
        Trees.of(
                ProgramTree.node(
                    new TemplateStep.Palletizing(
                        "tray", new Pattern.Line("A", "B", 4), "Base", false)))
            .withWaypoint("A", place(1))
            .withWaypoint("B", place(2));
    WaypointMarkers marks =
        ProgramPlaces.of(pattern, Installation.NONE, Set.of(), PoseForm.STANDARD);
    assertEquals(List.of(2L, 2L), marks.marks().stream().map(WaypointMarkers.Mark::node).toList());
  }

  @Test
  void suppressedNodesAreNotGoneTo() {
    ProgramTree less = tree.withNode(4, node -> node.withSuppressed(true));
    assertEquals(
        List.of(List.of(0, 0)),
        numbers(ProgramPlaces.of(less, Installation.NONE, Set.of(), PoseForm.STANDARD)));
  }

  @Test
  void aStopTellsHowItIsGoneTo() {
    WaypointMarkers.Stop stop =
        ProgramPlaces.of(tree, Installation.NONE, Set.of(), PoseForm.STANDARD)
            .ways()
            .getFirst()
            .getFirst();
    assertTrue(stop.how().matches("Move[JLP] at [0-9.]+ (deg|mm)/s"), stop.how());
  }
}
