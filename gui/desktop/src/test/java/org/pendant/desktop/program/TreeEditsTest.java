package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.shown;
import static org.pendant.desktop.program.Trees.waypoint;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

final class TreeEditsTest {
  /** Keys: a 2, F 3, b 4, c 5, d 6. */
  private final ProgramTree tree =
      Trees.of(comment("a"), folder("F", comment("b"), comment("c")), comment("d"));

  private List<ProgramNode> nodes(Long... keys) {
    return TreeEdits.tops(tree, List.of(keys));
  }

  @Test
  void nodesBelowChosenOnesGoAlong() {
    assertEquals(List.of(3L, 6L), TreeEdits.keys(nodes(6L, 4L, 3L)));
  }

  @Test
  void deletesAllButTheMainProgram() {
    assertEquals("a d", shown(TreeEdits.delete(tree, List.of(3L, 4L))));
    assertEquals(tree, TreeEdits.delete(tree, List.of(MAIN)));
  }

  @Test
  void selectsWhatIsNextToDeletedNodes() {
    assertEquals(OptionalLong.of(6), TreeEdits.afterDelete(tree, List.of(3L)));
    assertEquals(OptionalLong.of(3), TreeEdits.afterDelete(tree, List.of(6L)));
    assertEquals(OptionalLong.of(3), TreeEdits.afterDelete(tree, List.of(4L, 5L)));
  }

  @Test
  void movesSeveralNodesAndKeepsTheirKeys() {
    ProgramTree next = TreeEdits.move(tree, nodes(2L, 6L), new Spot(3, 1));
    assertEquals("F .b .a .d .c", shown(next));
    assertEquals(List.of(4L, 2L, 6L, 5L), TreeEdits.keys(next.childrenOf(3)));
  }

  @Test
  void movesBehindItsOwnPlaceCountTheGap() {
    assertEquals("F .b .c a d", shown(TreeEdits.move(tree, nodes(2L), new Spot(MAIN, 2))));
    assertEquals(tree, TreeEdits.move(tree, nodes(2L), new Spot(MAIN, 1)));
  }

  @Test
  void refusesToPutANodeBelowItself() {
    assertTrue(TreeEdits.whyNot(tree, nodes(3L), new Spot(3, 0), true).isPresent());
    assertTrue(TreeEdits.whyNot(tree, nodes(3L), new Spot(3, 0), false).isEmpty());
  }

  @Test
  void refusesWhatDoesNotStandThere() {
    ProgramTree other = Trees.of(move(waypoint("W")), comment("a"));
    ProgramNode waypoint = other.find(3).orElseThrow();
    Optional<String> whyNot = TreeEdits.whyNot(other, List.of(waypoint), new Spot(MAIN, 0), true);
    assertTrue(whyNot.orElse("").startsWith("Waypoint does not go below"), whyNot.toString());
  }

  @Test
  void shiftsPastNeighboursAndOutAtTheEdge() {
    assertEquals(Optional.of(new Spot(3, 2)), TreeEdits.shifted(tree, nodes(4L), true));
    assertEquals(Optional.of(new Spot(3, 0)), TreeEdits.shifted(tree, nodes(5L), false));
    assertEquals(Optional.of(new Spot(MAIN, 2)), TreeEdits.shifted(tree, nodes(5L), true));
    assertEquals(Optional.of(new Spot(MAIN, 1)), TreeEdits.shifted(tree, nodes(4L), false));
    assertEquals(Optional.empty(), TreeEdits.shifted(tree, nodes(2L), false));
  }

  @Test
  void suppressesAllUnlessAllAre() {
    ProgramTree one = TreeEdits.toggleSuppressed(tree, List.of(2L));
    assertEquals("-a F .b .c d", shown(one));
    ProgramTree both = TreeEdits.toggleSuppressed(one, List.of(2L, 6L));
    assertEquals("-a F .b .c -d", shown(both));
    assertEquals(tree, TreeEdits.toggleSuppressed(both, List.of(2L, 6L)));
  }

  @Test
  void duplicatesBehindTheLast() {
    assertEquals("a F .b .c a F .b .c d", shown(TreeEdits.duplicate(tree, List.of(2L, 3L))));
  }

  @Test
  void renamesPlacesWhereverTheyAreNamed() {
    ProgramTree both =
        Trees.of(move(waypoint("W"), waypoint("W"))).withWaypoint("W", Trees.place(1));
    ProgramTree next = Renames.rename(both, 3, "Pick");
    assertEquals("MoveJ .Pick .Pick", shown(next));
    assertEquals(List.of("Pick"), List.copyOf(next.waypoints().keySet()));
  }
}
