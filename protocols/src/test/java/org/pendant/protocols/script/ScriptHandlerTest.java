package org.pendant.protocols.script;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

class ScriptHandlerTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  private ScriptTrouble.NotCompiled trouble(String text) {
    Source source = Source.of("p", text.getBytes(StandardCharsets.ISO_8859_1));
    Diagnostic error =
        controller.load(source).diagnostics().stream()
            .filter(Diagnostic::isError)
            .findFirst()
            .orElseThrow();
    return ScriptHandler.notCompiled(source, error);
  }

  @Test
  void aSyntaxErrorIsWhereTheControllerGivesUp() {
    assertEquals(
        new ScriptTrouble.NotCompiled(4, 1, "syntax_error_on_line:4:end:"),
        trouble("def p():\n  while True:\n    sync()\nend\n"));
  }

  @Test
  void aMissingColonIsReportedAsTheControllerReportsIt() {
    assertEquals(
        new ScriptTrouble.NotCompiled(2, 1, "syntax_error_on_line:2:end:"),
        trouble("def silly()\nend\n"));
  }

  @Test
  void anUnknownNameIsPointedAt() {
    assertEquals(
        new ScriptTrouble.NotCompiled(2, 7, "compile_error_name_not_found:nothing:"),
        trouble("def p():\n  x = nothing()\nend\n"));
  }

  @Test
  void whatTheControllerHasNoWordsForIsInOurs() {
    ScriptTrouble.NotCompiled found = trouble("def p(a):\n  sync()\nend\n");
    assertEquals(1, found.line());
    assertEquals(
        "p is a library: it holds a function and no program; a program is a last def without"
            + " parameters",
        found.text());
  }
}
