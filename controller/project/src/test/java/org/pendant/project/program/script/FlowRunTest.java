package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.IoCommand;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.script.vm.Ending;

/** What decisions and loops do on a controller. */
final class FlowRunTest {
  private static final String INPUT = "get_standard_digital_in(0)";

  private static ProgramNode loop(LoopRule rule, ProgramNode... children) {
    return node(new FlowStep.Loop(rule), children);
  }

  private static ProgramNode when(String condition, ProgramNode... children) {
    return node(new FlowStep.If(condition, false), children);
  }

  /** Starts a program with digital input 0 high. */
  private static TreeRun high(ProgramTree tree) {
    TreeRun run = new TreeRun(tree);
    run.submit(new IoCommand.SetInput("digital_in[0]", true));
    return run;
  }

  private static TreeRun low(TreeRun run) {
    run.submit(new IoCommand.SetInput("digital_in[0]", false));
    return run;
  }

  @Test
  void theFirstBranchWhoseConditionHoldsRuns() {
    List<ProgramNode> nodes = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      nodes.add(assign("x", String.valueOf(i)));
      nodes.add(when("x == 0", say("if")));
      nodes.add(node(new FlowStep.ElseIf("x < 2"), say("first")));
      nodes.add(node(new FlowStep.ElseIf("x < 3"), say("second")));
      nodes.add(node(new FlowStep.Else(), say("else")));
    }
    assertEquals(
        List.of("if", "first", "second", "else"),
        TreeRun.of(program(nodes.toArray(ProgramNode[]::new))).said());
  }

  @Test
  void ofManyAlternativesTheRightOneRuns() {
    List<ProgramNode> nodes = new ArrayList<>(List.of(assign("x", "120"), when("x == 0")));
    for (int i = 1; i < 150; i++) {
      nodes.add(node(new FlowStep.ElseIf("x == " + i), say("branch " + i)));
    }
    assertEquals(
        List.of("branch 120"), TreeRun.of(program(nodes.toArray(ProgramNode[]::new))).said());
  }

  @Test
  void continuousIfIsLeftWhenItsConditionHoldsNoMore() {
    ProgramTree tree =
        program(
            sleep(0.1),
            node(new FlowStep.If(INPUT, true), say("in"), sleep(10), say("never")),
            node(new FlowStep.ElseIf("1 > 2"), say("never")),
            node(new FlowStep.Else(), say("else")),
            say("after"));
    TreeRun run = high(tree).until("in");
    low(run).finish();
    assertEquals(List.of("in", "else", "after"), run.said());
    assertTrue(run.timeS() < 1);
  }

  @Test
  void continuousIfStopsAMove() {
    ProgramTree tree =
        abc(
            program(
                sleep(0.1),
                node(new FlowStep.If(INPUT, true), moveJ(waypoint("A"), waypoint("B"))),
                sleep(1)));
    TreeRun run = high(tree).advanceS(0.4);
    assertTrue(run.state().arm().moving());
    low(run).finish();
    double turned = run.state().arm().targetPositionRad().q0();
    assertTrue(turned > 0.001 && turned < 0.19, () -> "turned to " + turned);
  }

  @Test
  void continuousIfThatEndsByItselfSkipsTheAlternatives() {
    ProgramTree tree =
        program(
            sleep(0.1),
            node(new FlowStep.If(INPUT, true), say("in"), sleep(0.1)),
            node(new FlowStep.Else(), say("never")),
            say("after"));
    assertEquals(List.of("in", "after"), high(tree).finish().said());
  }

  @Test
  void continuousIfThatNeverHeldRunsTheAlternatives() {
    ProgramTree tree =
        program(
            node(new FlowStep.If(INPUT, true), say("never")),
            node(new FlowStep.ElseIf("1 < 2"), say("other")));
    assertEquals(List.of("other"), TreeRun.of(tree).said());
  }

  @Test
  void loopsCountFromZero() {
    TreeRun run =
        TreeRun.of(
            program(
                loop(
                    new LoopRule.Times("2", ""),
                    loop(new LoopRule.Times("1 + 1", "turn"), script("textmsg(Loop_1, turn)")))));
    assertEquals(List.of("00", "01", "10", "11"), run.said());
    assertEquals("2", run.variable("turn"));
  }

  @Test
  void loopsRunWhileTheirConditionHolds() {
    TreeRun run =
        TreeRun.of(
            program(
                assign("x", "0"),
                loop(new LoopRule.While("x < 3", false), assign("x", "x + 1")),
                loop(new LoopRule.While("x < 3", false))));
    assertEquals("3", run.variable("x"));
  }

  @Test
  void endlessLoopsEndByTheirScript() {
    TreeRun run =
        TreeRun.of(
            program(
                assign("x", "0"),
                loop(
                    new LoopRule.Forever(), assign("x", "x + 1"), when("x > 4", script("break")))));
    assertEquals("5", run.variable("x"));
  }

  @Test
  void continuousLoopIsLeftWhenItsConditionHoldsNoMore() {
    ProgramTree tree =
        program(
            sleep(0.1),
            loop(new LoopRule.While(INPUT, true), say("turn"), sleep(0.4), sleep(0.4)),
            say("after"));
    TreeRun run = high(tree).advanceS(1.2);
    low(run).finish();
    assertEquals(List.of("turn", "turn", "after"), run.said());
    assertEquals(1.2, run.timeS(), 0.02);
  }

  @Test
  void branchesMayEndTheProgram() {
    ProgramNode halt = node(new ActionStep.Halt());
    TreeRun run =
        TreeRun.of(
            program(
                loop(new LoopRule.While("False", true), halt),
                node(new FlowStep.If("True", true), say("in"), halt)));
    assertEquals(List.of("in"), run.said());
    assertEquals(new Ending.Halted(), run.state().program().ending().orElseThrow());
  }

  @Test
  void switchRunsTheCaseThatFits() {
    List<ProgramNode> nodes = new ArrayList<>();
    for (int i = -1; i < 3; i++) {
      nodes.add(assign("x", String.valueOf(i)));
      nodes.add(
          node(
              new FlowStep.Switch("x"),
              node(new FlowStep.Case("-1"), say("minus")),
              node(new FlowStep.Case("0"), say("zero")),
              node(new FlowStep.Case("1"), assign("x", "0"), say("one")),
              node(new FlowStep.DefaultCase(), say("default"))));
    }
    assertEquals(
        List.of("minus", "zero", "one", "default"),
        TreeRun.of(program(nodes.toArray(ProgramNode[]::new))).said());
  }

  @Test
  void nestedFlowKeepsItsOrder() {
    TreeRun run =
        TreeRun.of(
            program(
                loop(
                    new LoopRule.Times("2", "i"),
                    when("i == 0", loop(new LoopRule.Times("2", ""), say("x"))),
                    node(
                        new FlowStep.Else(),
                        node(new FlowStep.Switch("i"), node(new FlowStep.Case("1"), say("y")))),
                    say("z"))));
    assertEquals(List.of("x", "x", "z", "y", "z"), run.said());
  }
}
