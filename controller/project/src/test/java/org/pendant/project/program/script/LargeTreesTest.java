package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.script.vm.ProgramLoader;

/** Programs with very many nodes, and very deep ones. */
final class LargeTreesTest {
  @Test
  void twoThousandNodesMakeOneProgram() {
    List<ProgramNode> nodes = new ArrayList<>();
    nodes.add(assign("x", "0"));
    while (nodes.size() < 400) {
      nodes.add(
          node(
              new FlowStep.If("x == " + nodes.size(), false),
              moveJ(waypoint("A")),
              sleep(0.1),
              assign("x", "x + 1")));
    }
    ProgramTree tree = abc(program(nodes.toArray(ProgramNode[]::new)));
    GeneratedScript script = ScriptGenerator.generate("large", tree, Installation.NONE);
    assertEquals(tree.nodes().size(), script.places().size());
    assertEquals(
        List.of(),
        ProgramLoader.load(Source.of("large", script.text()), StandardBuiltins.create())
            .diagnostics());
  }

  @Test
  void deepProgramsRun() {
    ProgramNode inner = say("deep");
    for (int i = 0; i < 45; i++) {
      inner =
          node(
              new FlowStep.If("True", false),
              node(new FlowStep.Loop(new LoopRule.Times("1", "")), inner));
    }
    assertEquals(List.of("deep"), TreeRun.of(program(inner)).said());
  }
}
