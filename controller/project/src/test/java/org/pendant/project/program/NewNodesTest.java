package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** What a palette adds. */
final class NewNodesTest {
  private static ProgramTree with(ProgramTree tree, NodeKind kind) {
    return tree.insert(tree.sections().getFirst().key(), 0, List.of(NewNodes.of(kind, tree)));
  }

  private static List<String> waypoints(ProgramNode node) {
    List<String> names = new ArrayList<>(TreeNames.waypoints(node.step()));
    node.children().forEach(each -> names.addAll(waypoints(each)));
    return names;
  }

  @ParameterizedTest
  @EnumSource(NodeKind.class)
  void aNewNodeIsOfItsKindAndItsChildrenMayStandThere(NodeKind kind) {
    if (kind.group() == NodeKind.Group.GIVEN) {
      assertThrows(IllegalArgumentException.class, () -> NewNodes.of(kind, ProgramTree.empty()));
      return;
    }
    ProgramNode node = NewNodes.of(kind, ProgramTree.empty());
    assertEquals(kind, NodeKind.of(node.step()));
    assertRightBelow(node);
  }

  private static void assertRightBelow(ProgramNode node) {
    for (ProgramNode child : node.children()) {
      assertTrue(Placement.allows(node.step(), child.step()), child::toString);
      assertRightBelow(child);
    }
  }

  @Test
  void movesHaveTheValuesOfTheRobotsScreenAndAWaypoint() {
    ProgramNode joint = NewNodes.of(NodeKind.MOVE_JOINT, ProgramTree.empty());
    MotionStep.Move move = (MotionStep.Move) joint.step();
    assertEquals(60, Math.toDegrees(move.speed()), 1e-9);
    assertEquals(80, Math.toDegrees(move.acceleration()), 1e-9);
    assertEquals(List.of("Waypoint_1"), waypoints(joint));
    MotionStep.Move line =
        (MotionStep.Move) NewNodes.of(NodeKind.MOVE_LINEAR, ProgramTree.empty()).step();
    assertEquals(0.25, line.speed());
    assertEquals(1.2, line.acceleration());
  }

  @Test
  void namesAreNewInTheTree() {
    ProgramTree tree = with(with(ProgramTree.empty(), NodeKind.MOVE_JOINT), NodeKind.CIRCLE_MOVE);
    assertEquals(List.of("Waypoint_4"), waypoints(NewNodes.of(NodeKind.WAYPOINT, tree)));
    assertEquals(
        List.of("Waypoint_4", "Waypoint_5"), waypoints(NewNodes.of(NodeKind.CIRCLE_MOVE, tree)));
    ProgramTree taught =
        ProgramTree.empty()
            .withWaypoint(
                "Waypoint_1",
                new WaypointPosition(Pose.ZERO, WaypointPosition.BASE, Joints.ZERO, Pose.ZERO));
    assertEquals(List.of("Waypoint_2"), waypoints(NewNodes.of(NodeKind.WAYPOINT, taught)));
  }

  @Test
  void variablesAndPartsGetNewNamesToo() {
    ProgramTree tree = with(ProgramTree.empty(), NodeKind.ASSIGNMENT);
    assertEquals(
        new ActionStep.Assignment("var_2", ""), NewNodes.of(NodeKind.ASSIGNMENT, tree).step());
    ProgramTree twice = with(with(ProgramTree.empty(), NodeKind.PALLETIZING), NodeKind.PALLETIZING);
    assertTrue(TreeNames.all(twice).containsAll(List.of("Pallet_1", "Pallet_2_count")));
  }

  @Test
  void whatANodeCannotDoWithoutIsThere() {
    assertEquals(List.of(NodeKind.CASE, NodeKind.DEFAULT_CASE), below(NodeKind.SWITCH));
    assertEquals(List.of(NodeKind.UNTIL), below(NodeKind.DIRECTION));
    assertEquals(
        List.of(NodeKind.APPROACH, NodeKind.PATTERN_POINT, NodeKind.EXIT),
        below(NodeKind.PALLETIZING));
    assertEquals(List.of(NodeKind.PART_SEQUENCE), below(NodeKind.DESTACK));
    assertEquals(List.of(NodeKind.WAYPOINT, NodeKind.WAYPOINT), below(NodeKind.CIRCLE_MOVE));
  }

  private static List<NodeKind> below(NodeKind kind) {
    return NewNodes.of(kind, ProgramTree.empty()).children().stream()
        .map(each -> NodeKind.of(each.step()))
        .toList();
  }
}
