package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/** Texts that are to be filled in before they are programs. */
final class TemplateTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "x = {{WIDTH}}\ny = {{HEIGHT}}\nz = )",
        "  {{BEGIN_REPLACE}}\nx = {{ y }}\nend",
        "{% if x %}\nmovej({{ q }})\n{% endif %}",
        "x = ${Width}\ny = ${Height}",
        "${body}\ny = ${Height}",
        "movej([${q}], a=${a})",
      })
  void saysOnceThatTheTextIsATemplate(String text) {
    List<Diagnostic> found = errors(text);
    assertEquals(1, found.size(), found::toString);
    assertEquals("template", found.getFirst().code());
    assertEquals(text.indexOf(text.contains("$") ? '$' : '{'), found.getFirst().range().start());
  }

  @Test
  void namesTheFirstMark() {
    Source source = Source.of("s", "def f():\n  x = {{A}} + {{B}}\nend\n");
    Diagnostic error = ScriptParser.parseProgram(source).diagnostics().getFirst();
    assertEquals(
        "this is a template: `{{A}}` and marks like it are to be filled in before it is a program",
        error.message());
    assertEquals("{{A}}", source.text(error.range()));
    assertEquals("syntax_error_on_line:2:  x = {{A}} + {{B}}:", error.wireText());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "x = \"{{A}} ${B} {% c %}\" # {{A}} ${B}\nsocket_send_string(\"${x}\")",
        "$ 1 \"label\"",
      })
  void marksInStringsAndCommentsAreText(String text) {
    assertEquals(List.of(), errors(text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "x = ) # {{A}}",
        "x = ) + \"{{A}}\"",
        "x = '{{A}}'",
        "x = \"{{A}}",
        "// {{A}}",
        "if (x) {\n y = 1\n}",
        "x = {1, {2}}",
        "x = {{1, 2}}",
        "x = {{a\n}}",
        "x = 1 $ 2 \"l\"",
      })
  void otherErrorsAreToldAsBefore(String text) {
    List<Diagnostic> found = errors(text);
    assertTrue(found.stream().noneMatch(each -> each.code().equals("template")), found::toString);
    assertTrue(!found.isEmpty());
  }

  private static List<Diagnostic> errors(String text) {
    return ScriptParser.parseProgram(Source.of("s", text)).diagnostics();
  }
}
