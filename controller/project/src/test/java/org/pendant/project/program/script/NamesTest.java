package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.taught;
import static org.pendant.project.program.script.TestTrees.tree;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;

/** What things are called in a script whose names people have made up freely. */
final class NamesTest {
  private static String program(String name) {
    String text = ScriptGenerator.generate(name, TestTrees.program(), Installation.NONE).text();
    return text.substring("def ".length(), text.indexOf('('));
  }

  @Test
  void programsHaveLegalNames() {
    assertEquals("pick_and_place", program("pick and place"));
    assertEquals("_3_boxes", program("3 boxes"));
    assertEquals("Gru246u223e_2", program("Gr\u00f6\u00dfe 2"));
    assertEquals("u20013u25991", program("\u4e2d\u6587"));
    assertEquals("program", program(""));
    assertEquals("while_2", program("while"));
    assertEquals("movej_2", program("movej"));
  }

  @Test
  void placesThatWouldShareANameGetTheirOwn() {
    ProgramTree tree =
        taught(
            taught(TestTrees.program(moveJ(waypoint("pick 1"), waypoint("pick-1"))), "pick 1", 0.1),
            "pick-1",
            0.3);
    String text = ScriptGenerator.generate("x", tree, Installation.NONE).text();
    assertTrue(text.contains("qnear=pick_1_q"), text);
    assertTrue(text.contains("qnear=pick_1_2_q"), text);
    assertEquals(0.3, TreeRun.of(tree).state().arm().targetPositionRad().q0(), 1e-6);
  }

  @Test
  void threadsAndSubProgramsOfAnyNameRun() {
    TreeRun run =
        TreeRun.of(
            tree(
                once(node(new ActionStep.Call("halt")), sleep(0.1)),
                node(new Section.SubProgram("halt", ""), say("sub")),
                node(new Section.ThreadSection("halt", false), say("thread")),
                node(new Section.ThreadSection("a b", false), say("first")),
                node(new Section.ThreadSection("a_b", false), say("second"))));
    assertEquals(4, run.said().size());
  }

  @Test
  void subProgramsKeepTheNameThatAVariableHasToo() {
    TreeRun run =
        TreeRun.of(
            tree(
                once(assign("pick", "3"), node(new ActionStep.Call("pick")), script("pick()")),
                node(new Section.SubProgram("pick", ""), script("textmsg(pick)"))));
    assertEquals(List.of("3", "3"), run.said());
  }

  @Test
  void variablesKeepTheNamesThatExpressionsUse() {
    TreeRun run =
        TreeRun.of(
            TestTrees.program(
                assign("time", "1"),
                assign("Loop_1", "7"),
                node(
                    new FlowStep.Loop(new LoopRule.Times("2", "")),
                    script("textmsg(time, Loop_1)"))));
    assertEquals(List.of("17", "17"), run.said());
  }

  @Test
  void namesThatNobodyGaveAreTold() {
    ProgramTree tree =
        taught(
            TestTrees.program(
                moveJ(waypoint("pick 1")),
                assign("placed", "1"),
                assign("my box", "2"),
                node(new FlowStep.Loop(new LoopRule.Times("2", "turn")), say("a")),
                node(new FlowStep.Loop(new LoopRule.Times("2", "")), say("b"))),
            "pick 1",
            0.1);
    GeneratedNames names = ScriptGenerator.generate("x y", tree, Installation.NONE).names();
    assertEquals("x_y", names.program());
    assertTrue(names.variables().containsAll(Set.of("pick_1_p", "pick_1_q", "Loop_1")));
    for (String given : List.of("placed", "my_box", "turn")) {
      assertFalse(names.variables().contains(given), given);
    }
  }

  @Test
  void helpersKeepOutOfTheWayOfWhatPeopleTyped() {
    TreeRun run =
        TreeRun.of(
            TestTrees.program(
                assign("thread_flag_1", "\"mine\""),
                script("def Thread_if_1():", "  textmsg(\"mine\")", "end"),
                node(new FlowStep.If("True", true), say("in")),
                script("Thread_if_1()"),
                script("textmsg(thread_flag_1)")));
    assertEquals(List.of("in", "mine", "mine"), run.said());
  }
}
