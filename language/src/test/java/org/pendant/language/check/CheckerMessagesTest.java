package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;

/** What the checker says, where that has several cases. */
final class CheckerMessagesTest {
  private static final String AT_ONCE = " in the secondary program s, which must end at once";

  @Test
  void aSecondaryProgramIsToldWhatMayTakeTimeInIt() {
    assertEquals(List.of("sleep takes robot time" + AT_ONCE), messages("sec s():\n sleep(1)\nend"));
    assertEquals(
        List.of("a thread is defined" + AT_ONCE, "run starts a thread" + AT_ONCE),
        messages("sec s():\n thread t():\n end\n run t()\nend"));
    assertEquals(List.of("join waits for a thread" + AT_ONCE), messages("sec s():\n join 1\nend"));
    assertEquals(
        List.of("socket_open may have to wait" + AT_ONCE),
        messages("sec s():\n socket_open()\nend"));
  }

  @Test
  void aParameterThatThereIsNotIsOfferedTheOneThatWasMeant() {
    assertEquals(
        "sleep has no parameter tt; did you mean t?; expected sleep(t)",
        Checks.message("sleep(tt = 1)"));
    assertEquals(
        "sleep has no parameter seconds; expected sleep(t)", Checks.message("sleep(seconds = 1)"));
  }

  @Test
  void aMethodThatThereIsNotIsOfferedTheOneThatWasMeant() {
    assertEquals(
        "a list has no method appendd; did you mean append?",
        Checks.message("x = [1]\nx.appendd(2)"));
    assertEquals("a list has no method zzzzz", Checks.message("x = [1]\nx.zzzzz(2)"));
  }

  @Test
  void aFunctionWithoutParenthesesNeedsThem() {
    assertEquals(
        "variable sync is never assigned; the function sync needs parentheses",
        Checks.message("x = sync"));
  }

  @Test
  void usesOfAMissingNameAreCountedFromTwoOn() {
    assertEquals(
        "function gone is not defined (and in 2 more places: lines 2, 3)",
        MissingNames.together(
                Checks.parse("gone()\ngone()\ngone()").source(),
                Checks.diagnostics("gone()\ngone()\ngone()"))
            .getFirst()
            .message());
  }

  @Test
  void onlyTheMainThreadIsExpectedToEnterInterpreterMode() {
    String expected = "; expected a call by the program's main thread";
    assertEquals(
        "interpreter_mode is called by a thread" + expected,
        Checks.message("thread t():\n interpreter_mode()\nend\nrun t()"));
    FunctionScope scope = Scopes.of(ProgramForm.of(Checks.parse("def p():\nend"))).mainScope();
    assertEquals(
        "interpreter_mode is called by an interpreted line" + expected,
        Checker.checkLine(Checks.parse("interpreter_mode()"), scope, new SmallCatalogue())
            .getFirst()
            .message());
  }

  private static List<String> messages(String text) {
    return Checks.diagnostics(text).stream().map(Diagnostic::message).toList();
  }
}
