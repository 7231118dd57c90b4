package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.forever;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.output;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.tree;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.script.GeneratedScript.NodeLines;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.vm.ProgramLabel;

/** Which lines of a script belong to which node. */
final class PlacesTest {
  private static final ProgramTree EVERYTHING =
      abc(
          tree(
              node(new Section.InitialValues(List.of(new Section.InitialValue("x", "0")))),
              node(new Section.BeforeStart(), sleep(0.1)),
              once(
                  moveJ(waypoint("A")),
                  node(new ActionStep.Folder("f"), output(0, true), output(1, true)),
                  suppressed(sleep(1)),
                  node(new FlowStep.If("x == 0", true), sleep(0.1)),
                  node(new FlowStep.ElseIf("x == 1"), say("1")),
                  node(new FlowStep.Else(), say("2")),
                  node(new FlowStep.Loop(new LoopRule.Times("2", "")), sleep(0.1)),
                  node(new FlowStep.Loop(new LoopRule.While("x > 0", true)), sleep(0.1)),
                  node(new FlowStep.Switch("x"), node(new FlowStep.Case("0"), assign("y", "1"))),
                  node(new ActionStep.Call("sub")),
                  node(new ActionStep.Timer("t", TimerAction.START))),
              node(new Section.ThreadSection("side", true), sleep(0.01)),
              node(new Section.Event("x == 5"), say("event")),
              node(new Section.SubProgram("sub", ""), moveL(waypoint("B")))));

  /** How the line begins at which a breakpoint stops, node by node. */
  private static final List<String> FIRST_LINES =
      List.of(
          "global x = 0",
          "sleep(0.1)",
          "sleep(0.1)",
          "movej(",
          "movej(",
          "movej(",
          "set_standard_digital_out(0, True)",
          "set_standard_digital_out(0, True)",
          "set_standard_digital_out(1, True)",
          "global thread_flag_11 = 0",
          "sleep(0.1)",
          "if (x == 1):",
          "textmsg(\"1\")",
          "textmsg(\"2\")",
          "textmsg(\"2\")",
          "Loop_1 = 0",
          "sleep(0.1)",
          "if (x > 0):",
          "sleep(0.1)",
          "switch_1 = x",
          "global y = 1",
          "global y = 1",
          "sub()",
          "t_is_counting = True",
          "sleep(0.01)",
          "sleep(0.01)",
          "if (x == 5):",
          "textmsg(\"event\")",
          "movel(",
          "movel(",
          "movel(");

  private static GeneratedScript generate(ProgramTree tree) {
    return ScriptGenerator.generate("test", tree, Installation.NONE);
  }

  @Test
  void nodesBeginWithTheirOwnFirstStatement() {
    GeneratedScript script = generate(EVERYTHING);
    List<String> lines = script.text().lines().toList();
    List<NodeLines> places = script.places();
    assertEquals(FIRST_LINES.size(), places.size());
    for (int i = 0; i < places.size(); i++) {
      String first = lines.get(places.get(i).first() - 1).strip();
      assertTrue(first.startsWith(FIRST_LINES.get(i)), i + ": " + first);
    }
  }

  @Test
  void numbersAndKeysAreThoseOfTheTree() {
    List<ProgramNode> nodes = EVERYTHING.nodes();
    for (NodeLines place : generate(EVERYTHING).places()) {
      assertEquals(nodes.get(place.number() - 1).key(), place.key());
    }
  }

  @Test
  void breakpointsStopWhereNodesBegin() {
    GeneratedScript script = generate(EVERYTHING);
    TreeRun run = new TreeRun(EVERYTHING);
    List<Integer> moved = new ArrayList<>();
    run.submit(
        new DebugCommand.Debug(
            debugger -> {
              for (NodeLines place : script.places()) {
                OptionalInt line = debugger.set(Breakpoint.at(place.first())).statementLine();
                if (!line.equals(OptionalInt.of(place.first()))) {
                  moved.add(place.number());
                }
              }
            }));
    assertEquals(List.of(), moved);
  }

  @Test
  void linesBelongToTheInnermostNode() {
    ProgramTree tree =
        tree(
            once(
                node(new FlowStep.If("True", false), sleep(1)),
                node(new FlowStep.Else(), sleep(2))));
    GeneratedScript script = generate(tree);
    List<String> lines = script.text().lines().toList();
    List<Integer> numbers = new ArrayList<>();
    for (int i = lines.indexOf("  $ 1 \"Robot Program\"") + 1; i <= lines.size(); i++) {
      numbers.add(script.at(i).map(NodeLines::number).orElse(0));
    }
    // label, label, if, label, sleep, else, label, label, sleep, end, end
    assertEquals(List.of(0, 0, 2, 2, 3, 1, 1, 1, 5, 1, 0), numbers);
  }

  @Test
  void labelsLeadFromTheLineToTheNode() {
    ProgramTree tree = abc(tree(forever(moveJ(waypoint("A"), waypoint("B")), sleep(0.2))));
    TreeRun run = new TreeRun(tree);
    Set<Integer> passed = new HashSet<>();
    for (int i = 0; i < 2000; i++) {
      run.advance(1);
      ProgramLabel.at(run.labels(), run.state().program().line())
          .ifPresent(label -> passed.add(label.number()));
    }
    assertEquals(Set.of(3, 4, 5), passed);
    assertEquals("A", run.labels().get(2).text());
  }

  @Test
  void nodesThatAreWrittenTwiceHaveTwoPlacesAndOneNumber() {
    ProgramTree tree = tree(once(sleep(1)));
    ProgramNode main = tree.sections().getFirst();
    ProgramNode twice =
        main.withChildren(List.of(main.children().getFirst(), main.children().getFirst()));
    List<NodeLines> places =
        generate(new ProgramTree("", tree.waypoints(), List.of(twice), tree.nextKey())).places();
    assertEquals(List.of(1, 2, 2), places.stream().map(NodeLines::number).toList());
    assertTrue(places.get(1).first() < places.get(2).first());
  }
}
