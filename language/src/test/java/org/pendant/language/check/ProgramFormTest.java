package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
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
    assertEquals(List.of("entry-parameters"), codes(form("def prog(a, b=1):\nend\n")));
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
