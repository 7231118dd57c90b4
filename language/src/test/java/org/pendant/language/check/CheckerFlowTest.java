package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;

/** Types, assignments, loops and robot time. */
final class CheckerFlowTest {

  @Test
  void certainTypeErrorsAreReported() {
    assertEquals("sqrt: f is a string, expected number", Checks.message("x = sqrt(\"a\")"));
    assertEquals("operator - does not take a string and a number", Checks.message("x = \"a\" - 1"));
    assertEquals("operator + does not take a string and a number", Checks.message("x = \"a\" + 1"));
    assertEquals("the condition is a list, expected a bool", Checks.message("if [1]:\nend"));
    assertEquals(List.of(), Checks.foundInBody("s = \"a\"\nif s and not (s xor \"\"):\nend"));
    assertEquals(List.of("2:type-mismatch"), Checks.foundInBody("x = not [1]"));
    assertEquals(List.of("2:type-mismatch"), Checks.foundInBody("p1 = p[\"a\",0,0,0,0,0]"));
    assertEquals(List.of("3:type-mismatch"), Checks.foundInBody("l = [1]\nx = l[\"a\"]"));
    assertEquals(List.of("3:type-mismatch"), Checks.foundInBody("n = 1\nx = n[0]"));
    assertEquals(
        List.of("3:type-mismatch"), Checks.foundInBody("n = p[0,0,0,0,0,0]\nn[1] = \"a\""));
    assertEquals(List.of("2:type-mismatch"), Checks.foundInBody("movej(\"home\")"));
    assertEquals(List.of("3:type-mismatch"), Checks.foundInBody("s = to_str(1)\nx = s * 2"));
    assertEquals(List.of("2:type-mismatch"), Checks.foundInBody("join \"t\""));
    assertEquals(List.of("3:unknown-member"), Checks.foundInBody("l = [1]\nx = l.y"));
  }

  @Test
  void globalsThatAlwaysHoldOneTypeAreKnownInFunctions() {
    assertEquals(
        List.of("4:type-mismatch"),
        Checks.foundInBody("name = \"a\"\ndef f():\n return sqrt(name)\nend\nf()"));
  }

  @Test
  void anAssignmentThatChangesTheTypeIsAnError() {
    assertEquals(
        "x holds a number, a string cannot replace it", Checks.message("x = 1\nx = \"a\""));
    assertEquals(List.of("4:type-change"), Checks.foundInBody("x = 1\nif x > 0:\n x = \"a\"\nend"));
    assertEquals(
        List.of("4:type-change"), Checks.foundInBody("x = 1\ndef f():\n x = \"a\"\nend\nf()"));
    assertEquals(
        List.of("3:type-change"), Checks.foundInBody("x = [0,0,0,0,0,0]\nx = p[0,0,0,0,0,0]"));
  }

  @Test
  void assignmentsOnDifferentPathsMayDiffer() {
    assertEquals(
        List.of(),
        Checks.foundInBody("if get_digital_in(0):\n x = 1\nelse:\n x = \"a\"\nend\ntextmsg(x)"));
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "def f(a):\n if a:\n  r = 1\n  return r\n end\n r = \"b\"\n return r\nend\nf(True)"));
  }

  @Test
  void numbersHandlesAndFractionsAreOneType() {
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "thread t():\n sync()\nend\nh = 0\nh = run t()\nif h != -1:\n kill h\nend\nh = -1.5"));
  }

  @Test
  void aVariableReadBeforeAnyAssignmentIsAnError() {
    assertEquals(List.of("2:unassigned-variable"), Checks.foundInBody("y = x\nx = 1"));
    assertEquals(List.of("2:unassigned-variable"), Checks.foundInBody("x = x + 1"));
    assertEquals(List.of("2:unassigned-variable"), Checks.foundInBody("while x < 3:\n x = 1\nend"));
    assertEquals(
        List.of("3:unassigned-variable"),
        Checks.foundInBody("def f():\n y = x\n x = 1\n return y\nend\nf()"));
    assertEquals(
        List.of("5:unassigned-variable"),
        Checks.foundInBody("if get_digital_in(0):\n x = 1\nelse:\n textmsg(x)\nend"));
    assertEquals(List.of("2:unassigned-variable"), Checks.foundInBody("x[0] = 1\nx = [1]"));
  }

  @Test
  void aVariableThatSomePathAssignsIsNot() {
    assertEquals(List.of(), Checks.foundInBody("if get_digital_in(0):\n x = 1\nend\ntextmsg(x)"));
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "n = 0\nwhile n < 3:\n if n > 0:\n  textmsg(last)\n end\n last = n\n n = n + 1\nend"));
    assertEquals(
        List.of(), Checks.foundInBody("init()\ntextmsg(x)\nx = 2\ndef init():\n x = 1\nend"));
    assertEquals(List.of(), Checks.foundInBody("interpreter_mode()\ntextmsg(x)\nx = 2"));
    assertEquals(
        List.of(), Checks.foundInBody("def f(a):\n local a = a + 1\n return a\nend\nf(1)"));
  }

  @Test
  void theNameOfAVariableAloneIsPointedOutAndAnyOtherIsAnError() {
    Diagnostic found = Checks.diagnostics("def prog():\n  x = 1\n  x\nend\n").getFirst();
    assertEquals("no-effect", found.code());
    assertEquals("`x` does nothing on its own", found.message());
    assertFalse(found.isError());
    assertEquals(
        "`stopl` does nothing on its own: expected `stopl = ...` or a call, `stopl(...)`",
        Checks.message("stopl"));
    assertTrue(Checks.diagnostics("def prog():\n  sync\nend\n").getFirst().isError());
  }

  @Test
  void breakAndContinueNeedALoopOfTheirOwnFunction() {
    assertEquals(List.of("2:outside-loop"), Checks.foundInBody("break"));
    assertEquals(List.of("2:outside-loop"), Checks.foundInBody("continue"));
    assertEquals(
        List.of("4:outside-loop"),
        Checks.foundInBody("while True:\n def f():\n  break\n end\n f()\n sync()\nend"));
  }

  @Test
  void aStatementAfterReturnIsUnreachable() {
    assertEquals(
        List.of("3:unreachable"),
        Checks.foundInBody("def f(): return 1\n textmsg(1)\n textmsg(2)\nend\nf()"));
    assertEquals(List.of("3:unreachable"), Checks.foundInBody("halt\nsync()"));
    assertEquals(List.of(), Checks.foundInBody("f()\nhalt\n$ 3 \"label\"\ndef f():\nend"));
  }

  @Test
  void anEndlessLoopWithoutAWaitIsWarnedAbout() {
    assertEquals(List.of("2:endless-loop"), Checks.foundInBody("while True:\n x = 1\nend"));
    assertEquals(
        List.of("2:endless-loop"),
        Checks.foundInBody("while (1 and not False):\n f()\nend\ndef f():\nend"));
    assertEquals(
        List.of("3:endless-loop"), Checks.foundInBody("while True:\n while True:\n end\nend"));
  }

  @Test
  void aLoopThatWaitsOrLeavesIsFine() {
    assertEquals(List.of(), Checks.foundInBody("while True:\n sync()\nend"));
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "while True:\n f()\nend\ndef f():\n g()\nend\ndef g():\n sleep(0.1)\nend"));
    assertEquals(
        List.of(), Checks.foundInBody("while True:\n if get_digital_in(1):\n  break\n end\nend"));
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "while True:\n while True:\n  if get_digital_in(1):\n   halt\n  end\n end\nend"));
    assertEquals(
        List.of(), Checks.foundInBody("while True:\n popup(\"wait\", blocking=True)\nend"));
    assertEquals(
        List.of("2:endless-loop"),
        Checks.foundInBody("while True:\n popup(\"on\", blocking=False)\nend"));
    assertEquals(List.of(), Checks.foundInBody("while get_digital_in(0) == False:\nend"));
  }

  @Test
  void aSecondaryProgramTakesNoRobotTime() {
    assertEquals(List.of(), Checks.found("sec s():\n set_digital_out(1, True)\nend\n"));
    assertEquals(List.of("2:physical-time"), Checks.found("sec s():\n sleep(1)\nend\n"));
    assertEquals(
        List.of("2:physical-time"),
        Checks.found("def f():\n sync()\nend\ndef g():\n f()\nend\nsec s():\n g()\nend\n"));
    assertEquals(
        List.of("2:physical-time", "4:physical-time"),
        Checks.found("sec s():\n thread t():\n end\n run t()\nend\n"));
    assertEquals(List.of(), Checks.found("def f():\n sync()\nend\nsec s():\n x = 1\nend\n"));
  }

  @Test
  void aSecondaryProgramStandsAlone() {
    assertEquals(List.of("2:nested-secondary"), Checks.foundInBody("sec s():\nend"));
  }

  @Test
  void onlyTheMainThreadEntersInterpreterMode() {
    assertEquals(
        List.of("3:interpreter-mode"),
        Checks.foundInBody("thread t():\n interpreter_mode()\nend\nrun t()"));
  }
}
