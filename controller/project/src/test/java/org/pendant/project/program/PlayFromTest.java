package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

class PlayFromTest {
  private static ProgramNode say(String text) {
    return node(new ActionStep.Comment(text));
  }

  private static ProgramNode waypoint(String name) {
    return node(
        new MotionStep.Waypoint(
            new WaypointTarget.Fixed(name), new Timing.AsMove(), OptionalDouble.empty()));
  }

  private static ProgramNode move(ProgramNode... waypoints) {
    return node(
        new MotionStep.Move(
            MoveKind.JOINT, 1, 1, new ToolChoice.Active(), WaypointPosition.BASE, false),
        waypoints);
  }

  private static ProgramTree tree(boolean forever, ProgramNode... nodes) {
    return new ProgramTree("", Map.of(), List.of(), 1)
        .insert(
            ProgramTree.ROOT,
            0,
            List.of(
                node(new Section.BeforeStart(), say("before")),
                node(new Section.MainProgram(forever), nodes)));
  }

  private static long key(ProgramTree tree, String comment) {
    return tree.nodes().stream()
        .filter(each -> each.step().equals(new ActionStep.Comment(comment)))
        .findFirst()
        .orElseThrow()
        .key();
  }

  /** What runs, in short: comments by their text, other nodes by their kind and children. */
  private static String sketch(List<ProgramNode> nodes) {
    StringBuilder sketch = new StringBuilder();
    for (ProgramNode each : nodes) {
      sketch.append(sketch.isEmpty() ? "" : " ");
      sketch.append(
          switch (each.step()) {
            case ActionStep.Comment comment -> comment.text();
            case MotionStep.Waypoint waypoint -> ((WaypointTarget.Fixed) waypoint.target()).name();
            default -> each.step().getClass().getSimpleName();
          });
      if (!each.children().isEmpty()) {
        sketch.append('(').append(sketch(each.children())).append(')');
      }
    }
    return sketch.toString();
  }

  private static String from(ProgramTree tree, String comment) {
    return sketch(PlayFrom.from(tree, key(tree, comment)).sections());
  }

  @Test
  void leavesOutWhatStandsBeforeInTheFirstTurnOnly() {
    ProgramTree tree = tree(true, say("a"), say("b"), say("c"));
    assertEquals("MainProgram(b c Loop(a b c))", from(tree, "b"));
    assertEquals("MainProgram(b c)", from(tree(false, say("a"), say("b"), say("c")), "b"));
  }

  @Test
  void continuesWithTheLoopThatItStartsIn() {
    ProgramNode loop =
        node(new FlowStep.Loop(new LoopRule.Times("3", "")), say("a"), say("b"), say("c"));
    assertEquals(
        "MainProgram(b c Loop(a b c) z)", from(tree(false, say("y"), loop, say("z")), "b"));
  }

  @Test
  void takesNoOtherBranchOfTheConditionThatItStartsIn() {
    ProgramTree tree =
        tree(
            false,
            node(new FlowStep.If("x", false), say("a"), say("b")),
            node(new FlowStep.ElseIf("y"), say("c")),
            node(new FlowStep.Else(), say("d")),
            say("z"),
            node(new FlowStep.If("x", false), say("e")),
            node(new FlowStep.Else(), say("f")));
    assertEquals("MainProgram(b z If(e) Else(f))", from(tree, "b"));
    assertEquals("MainProgram(c z If(e) Else(f))", from(tree, "c"));
    assertEquals("MainProgram(d z If(e) Else(f))", from(tree, "d"));
  }

  @Test
  void takesNoOtherCaseOfTheSwitchThatItStartsIn() {
    ProgramTree tree =
        tree(
            false,
            node(
                new FlowStep.Switch("x"),
                node(new FlowStep.Case("1"), say("a"), say("b")),
                node(new FlowStep.DefaultCase(), say("c"))),
            say("z"));
    assertEquals("MainProgram(b z)", from(tree, "b"));
  }

  @Test
  void keepsTheMoveAroundAWaypoint() {
    ProgramTree tree = tree(false, move(waypoint("P"), waypoint("Q"), waypoint("R")), say("z"));
    long q = tree.nodes().get(5).key();
    assertEquals("MainProgram(Move(Q R) z)", sketch(PlayFrom.from(tree, q).sections()));
  }

  @Test
  void theWholeProgramStartsAtItsMainNode() {
    ProgramTree tree = tree(true, say("a"));
    assertEquals(tree, PlayFrom.from(tree, tree.sections().get(1).key()));
  }

  @Test
  void saysWhyItCannotStartSomewhere() {
    ProgramTree tree =
        tree(
            true,
            node(new FlowStep.If("x", false)),
            node(new FlowStep.Else(), say("a").withSuppressed(true)),
            node(new TemplateStep.ConveyorTracking(1), say("b")));
    long otherwise = tree.nodes().get(4).key();
    assertTrue(PlayFrom.whyNot(tree, otherwise).orElseThrow().contains("branch"));
    assertTrue(PlayFrom.whyNot(tree, key(tree, "a")).orElseThrow().contains("suppressed"));
    assertTrue(PlayFrom.whyNot(tree, key(tree, "b")).orElseThrow().contains("part of a whole"));
    assertTrue(PlayFrom.whyNot(tree, key(tree, "before")).orElseThrow().contains("main program"));
    assertThrows(IllegalArgumentException.class, () -> PlayFrom.from(tree, key(tree, "before")));
  }

  @Test
  void findsTheFirstWaypointThroughBranchesAndCalls() {
    WaypointPosition there =
        new WaypointPosition(Pose.ZERO, WaypointPosition.BASE, Joints.ZERO, Pose.ZERO);
    ProgramTree tree =
        tree(
                true,
                move(waypoint("Off")).withSuppressed(true),
                node(new FlowStep.If("x", false), node(new ActionStep.Call("s"))),
                move(waypoint("Late")))
            .withWaypoint("First", there);
    ProgramTree called =
        tree.insert(
            ProgramTree.ROOT,
            2,
            List.of(
                node(
                    new Section.SubProgram("s", ""),
                    node(new ActionStep.Call("s")),
                    move(waypoint("First")))));
    assertEquals(Optional.of(new FirstWaypoint.Target("First", there)), FirstWaypoint.of(called));
    assertEquals(Optional.empty(), FirstWaypoint.of(tree), "Late was not taught");
  }
}
