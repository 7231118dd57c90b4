package org.pendant.gui.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.program.ProgramTree.node;
import static org.pendant.gui.program.Trees.comment;
import static org.pendant.gui.program.Trees.folder;
import static org.pendant.gui.program.Trees.move;
import static org.pendant.gui.program.Trees.waypoint;

import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.program.ActionStep;
import org.pendant.controller.program.FlowStep;
import org.pendant.controller.program.LoopRule;
import org.pendant.controller.program.ProgramNode;
import org.pendant.controller.program.ProgramTree;
import org.pendant.controller.program.Section;
import org.pendant.controller.program.WaitFor;
import org.pendant.controller.program.script.GeneratedScript;
import org.pendant.controller.program.script.ScriptGenerator;

final class TurnLineTest {

  /** The label where turns are counted; empty for none. */
  private static String label(ProgramTree tree) {
    GeneratedScript script = ScriptGenerator.generate("test", tree, Installation.NONE);
    int line = TurnLine.of(tree, script);
    return line == 0 ? "" : script.text().lines().toList().get(line - 1).strip();
  }

  private static ProgramNode assign(String name) {
    return node(new ActionStep.Assignment(name, "1"));
  }

  @Test
  void theFirstNodeThatComesOnceATurnIsTaken() {
    ProgramTree tree =
        Trees.of(
                comment("a"),
                node(new FlowStep.Loop(new LoopRule.Forever()), assign("inner")),
                node(new ActionStep.Wait(new WaitFor.Expression("True"))),
                folder("F", move(waypoint("A"))),
                assign("x"))
            .withWaypoint("A", Trees.place(0.4));
    assertTrue(label(tree).startsWith("$ 8 \"A\""), label(tree));
  }

  @Test
  void aProgramThatRunsOnceHasNoTurns() {
    ProgramTree tree = Trees.of(assign("x"));
    assertTrue(label(tree).startsWith("$ 2 "), label(tree));
    assertEquals("", label(tree.withStep(Trees.MAIN, new Section.MainProgram(false))));
  }

  @Test
  void turnsOfNothingButLoopsCannotBeCounted() {
    assertEquals("", label(Trees.of(node(new FlowStep.Loop(new LoopRule.Forever()), assign("x")))));
  }
}
