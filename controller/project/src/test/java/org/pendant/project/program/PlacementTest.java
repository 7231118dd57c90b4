package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which nodes may stand below which. */
final class PlacementTest {
  private static Step step(String title) {
    return NodeKind.titled(title)
        .filter(kind -> kind != NodeKind.MAIN_PROGRAM)
        .map(kind -> NewNodes.of(kind, ProgramTree.empty()).step())
        .orElseGet(() -> new Section.MainProgram(true));
  }

  @ParameterizedTest
  @CsvSource({
    "Main program, MoveJ",
    "Main program, If",
    "Main program, Palletizing",
    "Before start, Wait",
    "Thread, Loop",
    "Event, Set",
    "Sub program, Call",
    "MoveJ, Waypoint",
    "MoveL, Direction",
    "MoveL, Wait",
    "MoveP, CircleMove",
    "CircleMove, Waypoint",
    "Waypoint, Until",
    "Direction, Until",
    "Until, MoveL",
    "Folder, MoveJ",
    "If, MoveJ",
    "Loop, Else",
    "Loop, ElseIf",
    "Switch, Case",
    "Switch, Default",
    "Case, Popup",
    "Palletizing, Approach",
    "Palletizing, Before start part",
    "Palletizing, Set",
    "Seek: stack, Sequence part",
    "Seek: destack, Pattern point",
    "Sequence part, Exit",
    "Force, MoveL",
    "Screwdriving, Wait",
    "Conveyor tracking, MoveL"
  })
  void allows(String parent, String child) {
    assertEquals(Optional.empty(), Placement.whyNot(step(parent), step(child)));
    assertTrue(Placement.allows(step(parent), step(child)));
  }

  @ParameterizedTest
  @CsvSource({
    "Main program, Waypoint, 'Waypoint does not go below Main program, only below a move or a"
        + " circle'",
    "Main program, Until, 'Until does not go below Main program, only below a direction or a"
        + " waypoint'",
    "Folder, Thread, 'Thread does not go below Folder, only below the program itself'",
    "MoveJ, CircleMove, 'CircleMove does not go below MoveJ, only below a MoveP'",
    "MoveJ, MoveL, 'MoveL does not go below MoveJ, only below the main program or another part that"
        + " is not a move itself'",
    "Switch, Wait, 'Wait does not go below Switch, only below the main program, a thread, an event,"
        + " a sub program or what is below them'",
    "If, Case, 'Case does not go below If, only below a Switch'",
    "CircleMove, Direction, 'Direction does not go below CircleMove, only below a move'",
    "If, Approach, 'Approach does not go below If, only below Palletizing, Seek or their parts'",
    "Sequence part, Sequence part, 'Sequence part does not go below Sequence part, only below"
        + " Palletizing or Seek'",
    "Wait, Wait, Wait has no nodes below it",
    "Home, Waypoint, Home has no nodes below it",
    "Initial values, Wait, Initial values has no nodes below it"
  })
  void refuses(String parent, String child, String reason) {
    assertEquals(Optional.of(reason), Placement.whyNot(step(parent), step(child)));
    assertFalse(Placement.allows(step(parent), step(child)));
  }

  @Test
  void onlySectionsStandAtTheTopAndSomeOnlyOnce() {
    ProgramTree tree = ProgramTree.empty();
    assertEquals(
        Optional.of("a program has only one Main program"),
        Placement.whyNot(tree, ProgramTree.ROOT, new Section.MainProgram(false)));
    assertEquals(
        Optional.empty(), Placement.whyNot(tree, ProgramTree.ROOT, new Section.BeforeStart()));
    assertTrue(Placement.whyNot(tree, ProgramTree.ROOT, step("Wait")).isPresent());
    for (int i = 0; i < 2; i++) {
      assertEquals(Optional.empty(), Placement.whyNot(tree, ProgramTree.ROOT, step("Thread")));
      tree = tree.insert(ProgramTree.ROOT, 0, List.of(ProgramTree.node(step("Thread"))));
    }
  }

  @Test
  void aParentIsFoundByItsKey() {
    ProgramTree tree = ProgramTree.empty();
    long main = tree.sections().getFirst().key();
    assertEquals(Optional.empty(), Placement.whyNot(tree, main, step("Wait")));
    assertEquals(
        Optional.of("the node that it should go into is gone"),
        Placement.whyNot(tree, 99, step("Wait")));
  }
}
