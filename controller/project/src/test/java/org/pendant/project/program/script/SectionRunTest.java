package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.forever;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.tree;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.Section.InitialValue;

/** What the parts of a program do on a controller. */
final class SectionRunTest {
  private static ProgramNode thread(String name, boolean forever, ProgramNode... children) {
    return node(new Section.ThreadSection(name, forever), children);
  }

  private static ProgramNode event(String condition, ProgramNode... children) {
    return node(new Section.Event(condition), children);
  }

  private static ProgramNode call(String name) {
    return node(new ActionStep.Call(name));
  }

  private static long count(TreeRun run, String text) {
    return Collections.frequency(run.said(), text);
  }

  @Test
  void theHandleOfAThreadIsCalledAfterIt() {
    TreeRun run =
        TreeRun.of(
            tree(
                node(
                    new Section.MainProgram(false),
                    sleep(0.1),
                    node(new ActionStep.ScriptLine("kill threadId_Thread_1")),
                    sleep(0.1)),
                thread("Thread_1", true, say("tick"), sleep(0.03))));
    assertEquals(4, run.said().size(), () -> run.said().toString());
  }

  @Test
  void initialValuesComeFirstThenTheSequenceBeforeTheStart() {
    TreeRun run =
        TreeRun.of(
            tree(
                node(
                    new Section.InitialValues(
                        List.of(new InitialValue("x", "3"), new InitialValue("", "1")))),
                node(new Section.BeforeStart(), script("textmsg(\"before \", x)")),
                once(script("textmsg(\"main \", x)"))));
    assertEquals(List.of("before 3", "main 3"), run.said());
  }

  @Test
  void mainProgramBeginsAgainButNotTheSequenceBefore() {
    TreeRun run =
        new TreeRun(tree(node(new Section.BeforeStart(), say("before")), forever(say("turn"))));
    run.advance(20);
    assertTrue(count(run, "turn") > 5);
    assertEquals(1, count(run, "before"));
    assertTrue(run.running());
  }

  @Test
  void mainProgramThatRunsOnceEnds() {
    assertEquals(List.of("turn"), TreeRun.of(tree(once(say("turn")))).said());
  }

  @Test
  void threadsRunBesideTheMainProgram() {
    TreeRun run =
        TreeRun.of(
            tree(
                once(sleep(1.05)),
                thread("beat it", true, say("beat"), sleep(0.25)),
                thread("", false, say("once"), sleep(0.1), say("over")),
                suppressed(thread("gone", true, say("never")))));
    assertEquals(5, count(run, "beat"));
    assertEquals(1, count(run, "once"));
    assertEquals(1, count(run, "over"));
    assertEquals(0, count(run, "never"));
  }

  @Test
  void eventsRunOnceEachTimeTheirConditionComesToHold() {
    TreeRun run =
        TreeRun.of(
            tree(
                node(new Section.InitialValues(List.of(new InitialValue("x", "0")))),
                once(
                    assign("x", "1"),
                    sleep(0.2),
                    assign("x", "0"),
                    sleep(0.2),
                    assign("x", "1"),
                    sleep(0.2)),
                event("x == 1", say("one")),
                event("x == 0", say("zero"), sleep(0.05)),
                event("x > 5", say("never"))));
    assertEquals(2, count(run, "one"));
    assertEquals(1, count(run, "zero"));
    assertEquals(0, count(run, "never"));
  }

  @Test
  void subProgramsRunWhereTheyAreCalled() {
    TreeRun run =
        TreeRun.of(
            tree(
                once(call("pick up"), call("pick up"), call("missing"), call("outer")),
                node(new Section.SubProgram("pick up", ""), say("pick")),
                node(new Section.SubProgram("outer", "o.pendant"), call("pick up"), say("out"))));
    assertEquals(List.of("pick", "pick", "pick", "out"), run.said());
  }

  @Test
  void calledMovesKeepEndlessLoopsFromBeingRefused() {
    TreeRun run =
        new TreeRun(
            tree(
                forever(call("a"), call("b")),
                node(new Section.SubProgram("a", ""), call("b")),
                node(new Section.SubProgram("b", ""), call("a"), sleep(0.1))));
    assertTrue(run.state().frame() > 0);
  }
}
