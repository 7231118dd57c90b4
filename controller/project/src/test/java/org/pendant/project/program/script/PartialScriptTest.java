package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.forever;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.tree;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.script.GeneratedScript.NodeLines;

/** Scripts of programs that start in their middle. */
final class PartialScriptTest {
  private static final ProgramTree TREE =
      tree(
          node(new Section.BeforeStart(), assign("z", "0")),
          forever(
              node(new FlowStep.Loop(new LoopRule.Times("2", "")), assign("a", "1")),
              node(new FlowStep.Loop(new LoopRule.Times("3", "")), assign("b", "1")),
              sleep(0.1)));

  private static GeneratedScript from(String label) {
    return ScriptGenerator.generateFrom("test", TREE, key(label), Installation.NONE);
  }

  private static long key(String label) {
    return TREE.nodes().stream()
        .filter(each -> StepNames.label(each).startsWith(label))
        .findFirst()
        .orElseThrow()
        .key();
  }

  @Test
  void numbersAreThoseOfTheWholeProgram() {
    GeneratedScript part = from("Wait");
    List<String> labels =
        part.text().lines().map(String::strip).filter(line -> line.startsWith("$ ")).toList();
    assertEquals("$ 8 \"Wait: 0.1\"", labels.get(1));
    assertEquals(
        List.of(8, 8),
        part.places().stream()
            .filter(each -> each.key() == key("Wait"))
            .map(NodeLines::number)
            .toList());
  }

  @Test
  void namesAreThoseOfTheWholeProgram() {
    String whole = ScriptGenerator.generate("test", TREE, Installation.NONE).text();
    String counter = "Loop_2 < 3";
    assertTrue(whole.contains(counter), whole);
    assertTrue(from("b").text().contains(counter), from("b").text());
  }

  @Test
  void refusesNodesThatCannotBeStartedAt() {
    assertThrows(IllegalArgumentException.class, () -> from("z"));
  }
}
