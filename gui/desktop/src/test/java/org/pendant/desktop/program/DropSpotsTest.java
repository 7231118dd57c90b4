package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.waypoint;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

final class DropSpotsTest {
  /** Rows: 0 main 1, 1 a 2, 2 F 3, 3 b 4, 4 d 5. */
  private final ProgramTree tree = Trees.of(comment("a"), folder("F", comment("b")), comment("d"));

  private final List<TreeRow> rows = TreeRow.of(tree, Set.of());

  private DropSpots.Target drop(double y, double depth, ProgramNode... nodes) {
    return DropSpots.at(tree, rows, y, depth, List.of(nodes), false);
  }

  @Test
  void theMiddleOfAContainerTakesNodes() {
    DropSpots.Target target = drop(2.5, 1, comment("new"));
    assertEquals(new Spot(3, 1), target.spot());
    assertEquals(2, target.into());
  }

  @Test
  void theEdgesOfRowsAreBetweenThem() {
    assertEquals(new Spot(MAIN, 1), drop(1.9, 1, comment("new")).spot());
    assertEquals(new Spot(MAIN, 0), drop(1.1, 1, comment("new")).spot());
    assertEquals(-1, drop(1.1, 1, comment("new")).into());
  }

  @Test
  void behindALastChildThePointerChoosesTheLevel() {
    assertEquals(new Spot(3, 1), drop(3.9, 2, comment("new")).spot());
    assertEquals(new Spot(MAIN, 2), drop(3.9, 1, comment("new")).spot());
  }

  @Test
  void belowTheLastRowNodesGoToTheEnd() {
    assertEquals(new Spot(MAIN, 3), drop(9, 1, comment("new")).spot());
  }

  @Test
  void takesTheNearestPlaceThatIsAllowed() {
    ProgramTree moving = Trees.of(move(waypoint("W")), comment("a"));
    DropSpots.Target target =
        DropSpots.at(moving, TreeRow.of(moving, Set.of()), 2.9, 1, List.of(waypoint("X")), false);
    assertEquals(new Spot(2, 1), target.spot());
    assertTrue(target.refusal().isEmpty());
  }

  @Test
  void saysWhyWhereNothingIsAllowed() {
    DropSpots.Target target = drop(4.5, 1, waypoint("X"));
    assertTrue(target.refusal().orElse("").contains("Waypoint"), target.toString());
  }

  @Test
  void aNodeDoesNotGoBelowItself() {
    DropSpots.Target target =
        DropSpots.at(tree, rows, 2.5, 1, List.of(tree.find(3).orElseThrow()), true);
    assertTrue(target.refusal().isPresent() || target.spot().parent() == MAIN, target.toString());
  }
}
