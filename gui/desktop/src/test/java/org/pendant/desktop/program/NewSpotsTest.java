package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.waypoint;
import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;

final class NewSpotsTest {
  private static String added(ProgramTree tree, long selected, NodeKind kind) {
    return NewSpots.of(tree, OptionalLong.of(selected), kind)
        .map(each -> tree.insert(each.spot().parent(), each.spot().index(), each.nodes()))
        .map(Trees::shown)
        .orElse("refused");
  }

  @Test
  void goesIntoWhatHoldsNodesAndBehindWhatDoesNot() {
    ProgramTree tree = Trees.of(folder("F", comment("a"), comment("b")));
    assertEquals("F .a .b .Halt", added(tree, 2, NodeKind.HALT));
    assertEquals("F .a .Halt .b", added(tree, 3, NodeKind.HALT));
    assertEquals("F .a .b Halt", added(tree, MAIN, NodeKind.HALT));
  }

  @Test
  void waypointsComeWithAMoveWhereThereIsNone() {
    ProgramTree tree = Trees.of(comment("a"));
    assertEquals("a MoveJ .Waypoint_1", added(tree, 2, NodeKind.WAYPOINT));
    ProgramTree moving = Trees.of(move(waypoint("Waypoint_1")), comment("a"));
    assertEquals("MoveJ .Waypoint_1 .Waypoint_2 a", added(moving, 3, NodeKind.WAYPOINT));
  }

  @Test
  void otherBranchesGoBehindTheirIf() {
    ProgramTree tree =
        Trees.of(
            node(new FlowStep.If("x", false), comment("a")),
            node(new FlowStep.ElseIf("y")),
            comment("b"));
    assertEquals("If x .a ElseIf y Else b", added(tree, 3, NodeKind.ELSE));
    assertEquals("refused", added(tree, 5, NodeKind.ELSE));
  }

  @Test
  void nothingComesBetweenAnIfAndItsElse() {
    ProgramTree tree =
        Trees.of(node(new FlowStep.If("x", false)), node(new FlowStep.Else()), comment("b"));
    assertEquals(
        Optional.of(new Spot(MAIN, 2)),
        NewSpots.spot(tree, OptionalLong.of(2), comment("c").step(), false));
  }

  @Test
  void partsOfTheProgramHaveTheirOrder() {
    ProgramTree tree = Trees.of();
    assertEquals(
        new Spot(ProgramTree.ROOT, 0),
        NewSpots.of(tree, OptionalLong.empty(), NodeKind.BEFORE_START).orElseThrow().spot());
    assertEquals(
        new Spot(ProgramTree.ROOT, 1),
        NewSpots.of(tree, OptionalLong.empty(), NodeKind.THREAD).orElseThrow().spot());
    ProgramTree more = tree.insert(ProgramTree.ROOT, 0, List.of(node(new Section.BeforeStart())));
    assertEquals(Optional.empty(), NewSpots.of(more, OptionalLong.empty(), NodeKind.BEFORE_START));
  }
}
