package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;

/** Lines of interpreter mode. */
final class CheckLineTest {
  private final FunctionScope main =
      Scopes.of(
              ProgramForm.of(
                  Checks.parse(
                      "def prog():\n count = 0\n def f(a):\n end\n interpreter_mode()\nend\n")))
          .mainScope();

  @Test
  void aLineSeesTheProgramsNames() {
    assertEquals(List.of(), found(main, "count = count + 1 f(count) own = 2 textmsg(own)"));
    assertEquals(List.of("missing-argument"), found(main, "f()"));
    assertEquals(List.of("unknown-function"), found(main, "g()"));
    assertEquals(List.of("unknown-variable"), found(main, "textmsg(own)"));
    assertEquals(List.of("unassigned-variable"), found(main, "textmsg(own) own = 1"));
  }

  @Test
  void aLineSeesWhatEarlierLinesHaveAdded() {
    FunctionScope next =
        main.extendedBy(Checks.parse("own = 1 def g(): return 2 end").statements());
    assertEquals(List.of(), found(next, "textmsg(own) own = g()"));
  }

  @Test
  void whatAVariableOfTheProgramHoldsIsNotGuessed() {
    assertEquals(List.of(), found(main, "if False: count = \"a\" end x = sqrt(count)"));
  }

  @Test
  void newGlobalsAreRefused() {
    assertEquals(List.of(), found(main, "global count = 2"));
    assertEquals(List.of("interpreter-global"), found(main, "global fresh = 2"));
    assertEquals(List.of("interpreter-global"), found(main, "def g(): global fresh = 2 end"));
  }

  @Test
  void interpreterModeAndSecondaryProgramsAreRefused() {
    assertEquals(List.of("interpreter-mode"), found(main, "interpreter_mode()"));
    assertEquals(List.of("nested-secondary"), found(main, "sec s(): end"));
  }

  private static List<String> found(FunctionScope scope, String line) {
    return Checker.checkLine(Checks.parse(line), scope, new SmallCatalogue()).stream()
        .map(Diagnostic::code)
        .toList();
  }
}
