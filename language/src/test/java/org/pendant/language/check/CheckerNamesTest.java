package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;

/** Names, definitions and arguments. */
final class CheckerNamesTest {

  @Test
  void anUnknownFunctionIsAnErrorThatOffersTheNearestName() {
    Diagnostic found = Checks.diagnostics("def prog():\n  mvoej([0,0,0,0,0,0])\nend\n").getFirst();
    assertEquals("unknown-function", found.code());
    assertEquals("function mvoej is not defined; did you mean movej?", found.message());
    assertEquals("compile_error_name_not_found:mvoej:", found.wireText());
    assertEquals(14, found.range().start());
    assertEquals(19, found.range().end());
  }

  @Test
  void ownFunctionsAreOfferedToo() {
    assertEquals(
        "function pickup is not defined; did you mean pick_up?",
        Checks.message("pickup()\ndef pick_up():\nend"));
  }

  @Test
  void aNameNearNothingIsReportedWithoutAnOffer() {
    assertEquals("function zzzzzzzz is not defined", Checks.message("zzzzzzzz()"));
  }

  @Test
  void aVariableThatNothingAssignsIsPointedOut() {
    Diagnostic found = Checks.diagnostics("def prog():\n  b = colour\nend\n").getFirst();
    assertEquals("unknown-variable", found.code());
    assertFalse(found.isError());
    assertTrue(Checker.fails(found));
    assertEquals(
        "variable countr is never assigned; did you mean counter?",
        Checks.message("counter = 1\nb = countr"));
    assertEquals("variable Ture is never assigned; did you mean True?", Checks.message("b = Ture"));
    assertEquals(List.of(), Checks.foundInBody("b = true\nb = not false"));
    assertEquals(List.of("3:type-mismatch"), Checks.foundInBody("true = [1]\nb = not true"));
  }

  @Test
  void aCallThatLacksArgumentsIsPointedOut() {
    Diagnostic found =
        Checks.diagnostics("def prog():\n  def f(a, b=1):\n  end\n  f()\nend\n").getFirst();
    assertEquals("f is called without a; expected f(a, b=...)", found.message());
    assertFalse(found.isError());
    assertTrue(Checker.fails(found));
  }

  @Test
  void theLocalOfAnotherFunctionIsUnknown() {
    assertEquals(
        List.of("6:unknown-variable"),
        Checks.foundInBody(
            "def f():\n  inside = 1\nend\ndef g():\n  return inside\nend\nf()\ng()"));
  }

  @Test
  void functionsAndVariablesAreSeparateTables() {
    assertEquals(List.of(), Checks.foundInBody("time = 0\ntextmsg(time)\nstamp = time()"));
    assertEquals(
        "variable sqrt is never assigned; the function sqrt needs parentheses",
        Checks.message("x = sqrt"));
    assertEquals("x is a variable; expected a function to call", Checks.message("x = 1\nx()"));
  }

  @Test
  void aNestedFunctionIsUnknownOutsideItsBody() {
    assertEquals(
        List.of("5:unknown-function"),
        Checks.found("def f():\n  def inner():\n  end\nend\ndef prog(): inner() f() end"));
  }

  @Test
  void aBuiltinMayBeHiddenWithAWarning() {
    assertEquals(
        List.of("2:hides-builtin"), Checks.foundInBody("def sqrt(a, b):\nend\nsqrt(1, 2)"));
  }

  @Test
  void twoDefinitionsOfOneNameBesideEachOtherAreAnError() {
    assertEquals(
        List.of("4:duplicate-definition"), Checks.foundInBody("def f():\nend\ndef f():\nend\nf()"));
    assertEquals(
        List.of(),
        Checks.foundInBody("def f():\n def h():\n end\nend\ndef g():\n def h():\n end\nend\nf()"));
  }

  @Test
  void theNumberOfArgumentsIsChecked() {
    assertEquals("sleep is called without t; expected sleep(t)", Checks.message("sleep()"));
    assertEquals("sleep has 2 arguments, expected sleep(t)", Checks.message("sleep(1, 2)"));
    assertEquals(
        "f is called without a, b; expected f(a, b, c=...)",
        Checks.message("f(c=1)\ndef f(a, b, c=3):\nend"));
  }

  @Test
  void namedArgumentsAreCheckedAgainstTheHead() {
    assertEquals(
        List.of(),
        Checks.foundInBody("popup(\"a\", \"t\", False, True, blocking=True)\nsleep(t=1)"));
    assertEquals(List.of("2:unknown-argument"), Checks.foundInBody("popup(\"a\", bloking=True)"));
    assertTrue(Checks.message("popup(\"a\", bloking=True)").contains("did you mean blocking?"));
    assertEquals(List.of("2:duplicate-argument"), Checks.foundInBody("popup(\"a\", s=\"b\")"));
    assertEquals(
        List.of("2:duplicate-argument"), Checks.foundInBody("movej([0,0,0,0,0,0], a=1, a=2)"));
    assertEquals(List.of("2:positional-after-named"), Checks.foundInBody("sqrt(f=1, 2)"));
  }

  @Test
  void parametersHaveDifferentNames() {
    assertEquals(
        List.of("2:duplicate-parameter"), Checks.foundInBody("def f(a, a):\nend\nf(1, 2)"));
  }

  @Test
  void aDefaultSeesGlobalsFunctionsAndTheParametersBeforeIt() {
    assertEquals(
        List.of(),
        Checks.foundInBody(
            "x = 1\ndef g():\n return 1\nend\ndef f(x=x, b=g(), c=sqrt(b) + x):\nend\nf()"));
    assertEquals(List.of("2:unknown-function"), Checks.foundInBody("def f(a=g()):\nend\nf()"));
    assertEquals(List.of("2:unknown-variable"), Checks.foundInBody("def f(a=y):\nend\nf()"));
    assertEquals(List.of("2:type-mismatch"), Checks.foundInBody("def f(a=sqrt(\"x\")):\nend\nf()"));
    assertEquals(
        List.of("4:unknown-variable"),
        Checks.foundInBody("def g():\n local y = 1\n def f(a=y):\n end\n f()\nend\ng()"));
    assertEquals(
        List.of("1:unassigned-variable"), Checks.found("def prog(a=b, b=1):\n textmsg(a)\nend\n"));
  }

  @Test
  void aDefaultThatWaitsMakesItsFunctionWait() {
    assertEquals(
        List.of(),
        Checks.foundInBody("def g():\n sync()\nend\ndef f(a=g()):\nend\nwhile True:\n f()\nend"));
    assertEquals(
        List.of("1:physical-time"), Checks.found("def f(a=sync()):\nend\nsec s():\n f()\nend\n"));
  }

  @Test
  void structsTakeNamedArgumentsOnly() {
    assertEquals(List.of(), Checks.foundInBody("s = struct(a=1, b=struct(c=2))\nx = s.b.c"));
    assertEquals(List.of("2:struct-arguments"), Checks.foundInBody("s = struct(1)"));
    assertEquals(List.of("2:struct-arguments"), Checks.foundInBody("s = struct()"));
    assertEquals(List.of("2:duplicate-argument"), Checks.foundInBody("s = struct(a=1, a=2)"));
  }

  @Test
  void onlyThreadsAreRunAndOnlyFunctionsCalled() {
    String thread = "thread t():\n sync()\nend\n";
    assertEquals(List.of(), Checks.foundInBody(thread + "h = run t()\njoin h\nkill h"));
    assertEquals(List.of("5:not-a-function"), Checks.foundInBody(thread + "t()"));
    assertEquals(List.of("5:thread-arguments"), Checks.foundInBody(thread + "run t(1)"));
    assertEquals(List.of("5:unknown-function"), Checks.foundInBody(thread + "run tt()"));
    assertEquals(List.of("2:not-a-thread"), Checks.foundInBody("run f()\ndef f():\nend"));
    assertEquals(List.of("2:not-a-thread"), Checks.foundInBody("run sleep()"));
  }

  @Test
  void methodsAreCheckedWhereTheReceiverIsCertain() {
    assertEquals(List.of(), Checks.foundInBody("l = [1]\nl.append(2)\nn = l.length()"));
    assertEquals(
        "a list has no method lenght; did you mean length?",
        Checks.message("l = [1]\nn = l.lenght()"));
    assertEquals(List.of("2:missing-argument"), Checks.foundInBody("x = [1].append()"));
    assertEquals(List.of("3:unknown-method"), Checks.foundInBody("m = [[1,2],[3,4]]\nm.append(1)"));
    assertEquals(
        List.of(),
        Checks.foundInBody(
            """
            camera = rpc_factory("xmlrpc", "http://127.0.0.1/RPC2")
            if ! camera.initialize("RGB"):
              popup("no")
            end
            t = camera.server.getTarget()
            """));
  }

  @Test
  void aDeprecatedFunctionIsMentionedOnce() {
    assertEquals(List.of("2:deprecated"), Checks.foundInBody("set_flag_old()\nset_flag_old()"));
  }

  @Test
  void findingsComeInTheOrderOfTheText() {
    assertEquals(
        List.of("2:missing-argument", "3:unknown-function", "4:unknown-variable"),
        Checks.found("def f():\n sleep()\n gone()\n x = y\nend\ndef prog():\n f()\nend\n"));
  }

  @Test
  void aCallAfterTheProgramIsAWarningAmongTheFindings() {
    assertEquals(List.of("3:trailing-call"), Checks.found("def prog():\nend\nprog()\n"));
  }
}
