package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

/** Definitions, references and renaming; {@code |} is the caret. */
final class RenameTest {
  private static final String SHADOWED =
      """
      def prog():
        count = 0
        def step():
          local count = 1
          textmsg(count)
        end
        def add():
          count = count + 1
        end
        step()
        add()
      end
      """;

  @Test
  void globalsAssignedInFunctionsAreFoundAndLocalsOfTheSameNameAreNot() {
    assertEquals(List.of(2, 8, 8), referenceLines(SHADOWED.replaceFirst("count", "co|unt")));
  }

  @Test
  void aLocalIsFoundInItsFunctionOnly() {
    assertEquals(List.of(4, 5), referenceLines(SHADOWED.replace("local c", "local c|")));
  }

  @Test
  void theRightSideOfALocalAssignmentMeansTheOuterVariable() {
    String text = "def prog():\n  x = 1\n  def f():\n    local x = x|\n  end\n  f()\nend\n";
    assertEquals(List.of(2, 4), referenceLines(text));
    assertEquals(2, definitionLine(text));
  }

  @Test
  void parametersAreFoundAsNamesOfArgumentsToo() {
    String text = "def go(hei|ght=1):\n  textmsg(height)\nend\ndef prog():\n  go(height=2)\nend\n";
    assertEquals(List.of(1, 2, 5), referenceLines(text));
  }

  @Test
  void functionsAreFoundAtTheirCallsAndThreadsAtTheirRun() {
    String text = "def prog():\n  thread blink():\n  end\n  h = run bli|nk()\n  kill h\nend\n";
    assertEquals(List.of(2, 4), referenceLines(text));
    assertEquals(2, definitionLine(text));
  }

  @Test
  void aCallBehindTheProgramBelongsToIt() {
    assertEquals(List.of(1, 4), referenceLines("def pr|og():\n  sync()\nend\nprog()\n"));
  }

  @Test
  void nothingDefinesABuiltin() {
    Marked marked = Marked.of("def prog():\n  sy|nc()\nend\n");
    assertEquals(0, marked.analysis().definition(marked.caret()).stream().count());
  }

  @Test
  void everyOccurrenceIsRenamed() {
    assertEquals(
        SHADOWED
            .replace("  count = 0", "  total = 0")
            .replace("count = count + 1", "total = total + 1"),
        renamed(SHADOWED.replaceFirst("count", "|count"), "total"));
  }

  @Test
  void aNameThatWouldBecomeAnotherVariableIsRefused() {
    String text =
        "def prog():\n  a = 0|\n  def f():\n    b = 1\n    textmsg(b)\n  end\n  f()\nend\n"
            .replace("a = 0|", "|a = 0");
    assertEquals("b is taken: line 4 uses it", refusal(text, "b"));
    assertEquals(
        "count is taken: line 3 uses it",
        refusal(
            "def prog():\n  def f(|x):\n    textmsg(x + count)\n  end\n  count = 1\n  f(2)\nend\n",
            "count"));
  }

  @Test
  void aFunctionThatWouldHideAnotherIsRefused() {
    assertEquals(
        "g is taken: line 1 uses it",
        refusal("def g():\nend\ndef f|():\nend\ndef prog():\n  f()\n  g()\nend\n", "g"));
  }

  @Test
  void aVariableMayHaveTheNameOfAFunctionOfTheText() {
    assertEquals(
        "def f():\nend\ndef prog():\n  f = 1\n  f()\nend\n",
        renamed("def f():\nend\ndef prog():\n  |a = 1\n  f()\nend\n", "f"));
  }

  @Test
  void namesThatCannotBeGivenAreRefused() {
    String text = "def prog():\n  |a = 1\nend\n";
    assertEquals("while is a reserved word", refusal(text, "while"));
    assertEquals(
        "movej is a built-in function; expected a name of its own", refusal(text, "movej"));
    assertEquals(
        "`2b` is no name; expected letters, digits and _, no digit first", refusal(text, "2b"));
    assertEquals(
        "`a b` is no name; expected letters, digits and _, no digit first", refusal(text, "a b"));
  }

  @Test
  void whatTheProgramDoesNotDefineIsRefused() {
    assertEquals(
        "sync is built in; expected a name that this program defines",
        refusal("def prog():\n  sy|nc()\nend\n", "wait"));
    assertEquals(
        "v is built in; expected a name that this program defines",
        refusal("def prog():\n  movej([0,0,0,0,0,0], |v=1)\nend\n", "speed"));
    assertEquals(
        "x is a member, which may belong to several structs",
        refusal("def prog():\n  s = struct(|x=1)\nend\n", "y"));
    assertEquals(
        "nothing defines b; expected a name with a meaning",
        refusal("def prog():\n  a = |b\nend\n", "c"));
    assertEquals("no name stands here", refusal("def prog():\n  a = |1\nend\n", "c"));
  }

  @Test
  void aTextWithSyntaxErrorsIsRefused() {
    assertEquals(
        "line 2 has a syntax error; expected a text that can be read as a whole",
        refusal("a| = 1\nb = = 2\n", "c"));
  }

  private static List<Integer> referenceLines(String text) {
    Marked marked = Marked.of(text);
    ScriptAnalysis analysis = marked.analysis();
    return analysis.references(marked.caret()).stream()
        .map(found -> analysis.source().line(found.range().start()))
        .toList();
  }

  private static int definitionLine(String text) {
    Marked marked = Marked.of(text);
    ScriptAnalysis analysis = marked.analysis();
    return analysis.source().line(analysis.definition(marked.caret()).orElseThrow().start());
  }

  private static String renamed(String text, String newName) {
    Marked marked = Marked.of(text);
    Source source = marked.analysis().source();
    RenameResult result = marked.analysis().rename(marked.caret(), newName);
    RenameResult.Renamed done = assertInstanceOf(RenameResult.Renamed.class, result);
    return TextEdit.apply(source, done.edits()).text();
  }

  private static String refusal(String text, String newName) {
    Marked marked = Marked.of(text);
    RenameResult result = marked.analysis().rename(marked.caret(), newName);
    return assertInstanceOf(RenameResult.Refused.class, result).reason();
  }
}
