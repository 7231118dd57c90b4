package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement.Definition;

final class ProgramFormTest {

  @Test
  void theLastFunctionOfAFileIsTheProgram() {
    ProgramForm form = form("def a():\nend\n$ 1 \"label\"\ndef b():\n x = 1\nend\n");
    assertEquals(ProgramForm.Kind.PROGRAM, form.kind());
    assertEquals("b", form.name());
    assertEquals(1, form.body().size());
    assertEquals(List.of("a"), names(form.siblings()));
    assertEquals(List.of(), form.problems());
  }

  @Test
  void aThreadAfterTheLastFunctionDoesNotReplaceIt() {
    ProgramForm form = form("def b():\nend\nthread t():\nend\n");
    assertEquals("b", form.name());
    assertEquals(List.of("t"), names(form.siblings()));
  }

  @Test
  void aFileThatEndsWithASecondaryProgramIsOne() {
    ProgramForm form = form("def f():\nend\nsec blink():\n f()\nend\n");
    assertEquals(ProgramForm.Kind.SECONDARY, form.kind());
    assertEquals("blink", form.name());
    assertEquals(List.of("f"), names(form.siblings()));
  }

  @Test
  void statementsBesideDefinitionsMakeAFragmentNamedAfterItsFile() {
    ProgramForm form =
        ProgramForm.of(
            ScriptParser.parseProgram(Source.of("dir/grip.er.script", "def f():\nend\nx = 1\n"))
                .script());
    assertEquals(ProgramForm.Kind.FRAGMENT, form.kind());
    assertEquals("grip.er", form.name());
    assertEquals(2, form.body().size());
    assertEquals(List.of(), form.siblings());
    assertTrue(form.entry().isEmpty());
  }

  @Test
  void aCustomaryCallOfTheLastFunctionIsOnlyWarnedAbout() {
    ProgramForm form = form("def f():\nend\ndef prog():\nend\nprog()\n");
    assertEquals(ProgramForm.Kind.PROGRAM, form.kind());
    assertEquals("prog", form.name());
    assertEquals(List.of("trailing-call"), codes(form));
  }

  @Test
  void aCallOfAnotherFunctionOrWithArgumentsMakesAFragment() {
    assertEquals(ProgramForm.Kind.FRAGMENT, form("def f():\nend\ndef prog():\nend\nf()\n").kind());
    assertEquals(ProgramForm.Kind.FRAGMENT, form("def prog(a=1):\nend\nprog(2)\n").kind());
    assertEquals(ProgramForm.Kind.FRAGMENT, form("prog()\ndef prog():\nend\n").kind());
  }

  @Test
  void aFileWithoutAnythingHoldsNoProgram() {
    assertEquals(List.of("empty-program"), codes(form("# only a comment\n")));
    assertEquals(List.of("empty-program"), codes(form("")));
  }

  @Test
  void aProgramCannotRequireParameters() {
    assertEquals(List.of("entry-parameters"), codes(form("sec prog(a, b=1):\nend\n")));
    assertEquals(
        List.of("trailing-call", "entry-parameters"),
        codes(form("def prog(a, b=1):\nend\nprog()\n")));
  }

  @Test
  void functionsOfWhichTheLastNeedsValuesAreALibrary() {
    ProgramForm form = form("def f():\nend\n$ 1 \"label\"\ndef g(a, b=1):\nend\n");
    assertEquals(ProgramForm.Kind.LIBRARY, form.kind());
    assertEquals("test", form.name());
    assertEquals(3, form.body().size());
    assertTrue(form.entry().isEmpty());
    assertEquals(List.of(), form.problems());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "def g(a):\nend\n",
        "def g(a):\nend\nthread t():\nend\n",
        "speed = -0.5\nglobal home = [p[0,0,0,0,0,0]]\ndef g(a):\nend\n",
        "s = struct(a = sqrt(2)).a\ndef g(a):\nend\n",
      })
  void whatOnlyDefinesIsALibrary(String text) {
    assertEquals(ProgramForm.Kind.LIBRARY, form(text).kind());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "def g(a):\nend\ng(1)\n",
        "def g(a):\nend\nx = g(1)\n",
        "def g(a):\nend\nx = [1 + sqrt(g(1))]\n",
        "def g(a):\nend\nthread t():\nend\nx = run t()\n",
        "def g(a):\nend\nif 1 == 1:\n x = 1\nend\n",
        "x = 1\ndef g(a=1):\nend\n",
        "x = 1\ndef g():\nend\n",
      })
  void whatDoesSomethingOrCouldRunIsNone(String text) {
    assertEquals(ProgramForm.Kind.FRAGMENT, form(text).kind());
  }

  private static ProgramForm form(String text) {
    return ProgramForm.of(Checks.parse(text));
  }

  private static List<String> names(List<Definition> definitions) {
    return definitions.stream().map(Definition::name).toList();
  }

  private static List<String> codes(ProgramForm form) {
    return form.problems().stream().map(Diagnostic::code).toList();
  }
}
