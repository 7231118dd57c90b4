package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.waypoint;
import static org.pendant.project.program.ProgramTree.node;

import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;

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
