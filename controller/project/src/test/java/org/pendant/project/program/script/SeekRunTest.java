package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep.Part;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternPoint;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.TemplateStep.Seek;
import org.pendant.project.program.WaypointPosition;
import org.pendant.script.value.Value;

/** Searching along a stack for the next item. */
final class SeekRunTest {
  private static final double ITEM_M = 0.02;

  private static ProgramNode seek(boolean destack, String found, ProgramNode... children) {
    return node(
        new Seek(
            destack,
            "stack",
            "top",
            WaypointPosition.BASE,
            List.of(0.0, 0.0, -1.0),
            0.12,
            ITEM_M,
            found,
            0.1,
            1),
        children);
  }

  private static ProgramNode part(PartKind kind, ProgramNode... children) {
    return node(new Part(kind), children);
  }

  private static ProgramNode sequence(ProgramNode... children) {
    return part(PartKind.SEQUENCE, children);
  }

  private static ProgramNode times(int count, ProgramNode... children) {
    return node(new FlowStep.Loop(new LoopRule.Times(String.valueOf(count), "")), children);
  }

  private static ProgramTree taught(ProgramNode... nodes) {
    return program(nodes).withWaypoint("top", ArmRun.place(0, 0, -0.02));
  }

  /** Where the tool was, mm below where it was at first, whenever the program said something. */
  private static List<String> story(ArmRun run) {
    List<String> story = new ArrayList<>();
    while (run.running()) {
      run.advance(1);
      for (int i = story.size(); i < run.said().size(); i++) {
        story.add(run.said().get(i) + " " + Math.round(-1000 * run.moved().z()));
      }
    }
    run.finish();
    return story;
  }

  /** What an expression is compared with: so far below where the tool was at first. */
  private static String below(double depthM) {
    return String.valueOf(ArmRun.HERE.z() - depthM);
  }

  @Test
  void eachItemOfAStackIsFoundInTurnAndThenItsEnd() {
    ProgramTree tree =
        taught(
            assign("level", below(0.05)),
            times(
                4,
                seek(
                    true,
                    "get_target_tcp_pose()[2] <= level and level > " + below(0.1),
                    part(PartKind.BEFORE_START, say("before")),
                    sequence(say("item"), assign("level", "level - 0.02")),
                    part(PartKind.AFTER_END, say("after")))));
    ArmRun run = new ArmRun(tree);
    assertEquals(List.of("before 0", "item 50", "item 70", "item 90", "after 140"), story(run));
    assertEquals(Value.of(0), run.variable("stack_count"));
  }

  @Test
  void itemsPutOnAStackAreFoundHigherEachTimeUntilItIsFull() {
    ProgramTree tree =
        taught(
            assign("level", below(0.07)),
            times(
                3,
                seek(
                    false,
                    "get_target_tcp_pose()[2] <= level",
                    part(PartKind.BEFORE_START, say("before")),
                    sequence(say("item"), assign("level", "level + 0.02")),
                    part(PartKind.AFTER_END, say("full")))));
    assertEquals(
        List.of("before 0", "item 70", "item 50", "item 30", "full 30"), story(new ArmRun(tree)));
  }

  @Test
  void theNextSearchBeginsOneItemBeforeTheNextOne() {
    ProgramTree tree =
        taught(times(2, seek(true, "get_target_tcp_pose()[2] <= " + below(0.05), say("item"))));
    ArmRun run = new ArmRun(tree);
    run.until("item");
    List<Double> depths = new ArrayList<>();
    while (run.running()) {
      run.advance(1);
      depths.add(run.moved().z());
    }
    run.finish();
    assertEquals(-0.02, depths.stream().mapToDouble(z -> z).max().orElseThrow(), 1e-4);
    assertEquals(Value.of(2), run.variable("stack_count"));
  }

  @Test
  void aTableIsFoundByTouchingIt() {
    ProgramTree tree =
        taught(
            seek(
                true, "tool_contact(direction=[0, 0, -1, 0, 0, 0]) > 0", sequence(say("touched"))));
    ArmRun run = new ArmRun(tree, ArmRun.table(0.06));
    double most = 0;
    while (run.running()) {
      run.advance(1);
      most = Math.max(most, run.pressN());
    }
    run.finish();
    assertEquals(List.of("touched"), run.said());
    assertTrue(most > 5);
    assertEquals(-0.06, run.moved().z(), 1e-3);
  }

  @Test
  void placesOfTheSequenceLieToWhatWasFound() {
    ProgramTree tree =
        taught(
                seek(
                    true,
                    "get_target_tcp_pose()[2] <= " + below(0.05),
                    sequence(
                        point(PatternRole.APPROACH, "beside"),
                        say("beside"),
                        point(PatternRole.POINT, "reference"),
                        say("item"))))
            .withWaypoint("reference", ArmRun.place(0.1, 0, -0.1))
            .withWaypoint("beside", ArmRun.place(0.1, 0.03, -0.1));
    ArmRun run = new ArmRun(tree, ControllerOptions.headless());
    run.until("beside");
    assertEquals(0.03, run.moved().y(), 1e-5);
    assertEquals(-0.05, run.moved().z(), 3e-4);
    run.finish();
    assertEquals(0, run.moved().y(), 1e-5);
  }

  private static ProgramNode point(PatternRole role, String waypoint) {
    return node(new PatternPoint(role, waypoint, MoveKind.LINEAR, 0.5, 2, OptionalDouble.empty()));
  }
}
