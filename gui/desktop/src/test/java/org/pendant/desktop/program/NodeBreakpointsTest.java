package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.waypoint;
import static org.pendant.project.program.ProgramTree.node;

import java.util.HashSet;
import java.util.List;
import java.util.NavigableSet;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;

/** Beside which nodes breakpoints stand. */
final class NodeBreakpointsTest {
  private static final long FOLDER = 2;
  private static final long MOVE = 3;
  private static final long FIRST = 4;
  private static final long SECOND = 5;

  private final NodeBreakpoints breakpoints = new NodeBreakpoints();
  private final NavigableSet<Integer> script = new TreeSet<>();
  private final NodeBreakpoints.Lines lines =
      new NodeBreakpoints.Lines() {
        @Override
        public SortedSet<Integer> all() {
          return script;
        }

        @Override
        public void toggle(int line) {
          if (!script.add(line)) {
            script.remove(line);
          }
        }
      };
  private ProgramTree tree =
      Trees.of(folder("F", move(waypoint("A"), waypoint("B"))))
          .withWaypoint("A", Trees.place(0.4))
          .withWaypoint("B", Trees.place(0.5));
  private GeneratedScript now = generated();

  private GeneratedScript generated() {
    return ScriptGenerator.generate("p", tree, Installation.NONE);
  }

  private int first(long key) {
    return now.of(key).orElseThrow().first();
  }

  private boolean toggle(long key) {
    return breakpoints.toggle(now, key, lines);
  }

  private Set<Long> shown() {
    Set<Long> keys = new HashSet<>();
    script.forEach(line -> keys.addAll(breakpoints.nodes(now, line)));
    return keys;
  }

  /** As the desktop does it when a tree changes. */
  private void change(ProgramTree next) {
    GeneratedScript before = now;
    tree = next;
    now = generated();
    breakpoints.forgetCleared(lines);
    List<Integer> moved =
        script.stream().map(line -> breakpoints.moved(before, now, line)).toList();
    script.clear();
    moved.stream().filter(line -> line > 0).forEach(script::add);
    breakpoints.follow(before, now, lines);
  }

  @Test
  void aNodeThatHoldsOthersHasItsOwn() {
    assertEquals(first(FIRST), first(FOLDER), "one line for all three");
    for (long key : new long[] {1, FOLDER, MOVE, FIRST}) {
      assertTrue(toggle(key));
      assertEquals(Set.of(key), shown());
      assertEquals(Set.of(first(FIRST)), script);
      assertTrue(toggle(key));
      assertEquals(Set.of(), shown());
      assertEquals(Set.of(), script);
    }
  }

  @Test
  void loopsAndDecisionsHaveTheirOwn() {
    ProgramNode halt = node(new ActionStep.Halt());
    List<ProgramNode> holders =
        List.of(
            node(new FlowStep.Loop(new LoopRule.Forever()), halt),
            node(new FlowStep.Loop(new LoopRule.Times("3", "")), halt),
            node(new FlowStep.If("True", false), halt));
    for (ProgramNode each : holders) {
      tree = Trees.of(each);
      now = generated();
      toggle(2);
      assertEquals(Set.of(2L), shown(), each.step()::toString);
      toggle(3);
      assertEquals(Set.of(2L, 3L), shown(), each.step()::toString);
      toggle(2);
      assertEquals(Set.of(3L), shown(), each.step()::toString);
      toggle(3);
      assertEquals(Set.of(), script, each.step()::toString);
    }
  }

  @Test
  void severalNodesShareALine() {
    toggle(MOVE);
    toggle(FIRST);
    assertEquals(Set.of(MOVE, FIRST), shown());
    assertEquals(1, script.size());
    toggle(MOVE);
    assertEquals(Set.of(FIRST), shown());
    assertEquals(1, script.size());
    toggle(FIRST);
    assertEquals(Set.of(), script);
  }

  @Test
  void whatWasSetInTheScriptStandsAtTheInnermostNode() {
    script.add(first(MOVE));
    assertEquals(Set.of(FIRST), shown());
    toggle(MOVE);
    assertEquals(Set.of(MOVE, FIRST), shown());
    toggle(FIRST);
    assertEquals(Set.of(MOVE), shown());
    assertEquals(1, script.size());
  }

  @Test
  void whatWasClearedInTheScriptIsForgotten() {
    toggle(MOVE);
    script.clear();
    assertEquals(Set.of(), shown());
    breakpoints.forgetCleared(lines);
    script.add(first(MOVE));
    assertEquals(Set.of(FIRST), shown());
  }

  @Test
  void theNodeKeepsItWhenOthersComeBeforeItsFirst() {
    toggle(MOVE);
    change(tree.insert(MOVE, 0, List.of(waypoint("B"))));
    assertEquals(Set.of(MOVE), shown());
    assertEquals(Set.of(first(MOVE)), script);
    assertTrue(first(MOVE) < first(FIRST));
  }

  @Test
  void nodesThatBeginElsewhereFromNowOnGetOneEach() {
    toggle(MOVE);
    toggle(FIRST);
    change(tree.insert(MOVE, 0, List.of(waypoint("B"))));
    assertEquals(Set.of(MOVE, FIRST), shown());
    assertEquals(Set.of(first(MOVE), first(FIRST)), script);
  }

  @Test
  void theHolderKeepsItWhenItsFirstGoes() {
    toggle(MOVE);
    change(tree.remove(List.of(FIRST)));
    assertEquals(Set.of(MOVE), shown());
    assertEquals(Set.of(first(SECOND)), script);
    change(tree.remove(List.of(MOVE)));
    assertEquals(Set.of(), script);
  }

  @Test
  void aNodeThatGeneratesNothingHasNone() {
    change(tree.withNode(SECOND, each -> each.withSuppressed(true)));
    assertFalse(toggle(SECOND));
    assertEquals(Set.of(), script);
  }

  @Test
  void theLineIsTheOneWhereTheScriptPutsIt() {
    NodeBreakpoints.Lines shifting =
        new NodeBreakpoints.Lines() {
          @Override
          public SortedSet<Integer> all() {
            return script;
          }

          @Override
          public void toggle(int line) {
            lines.toggle(line + 1);
          }
        };
    breakpoints.toggle(now, SECOND, shifting);
    assertEquals(Set.of(first(SECOND) + 1), script);
    assertEquals(Set.of(SECOND), shown());
  }
}
