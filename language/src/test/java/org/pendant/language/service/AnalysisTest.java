package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.SourceRange;

/** Signature help, hover, outline, folding and breakpoints; {@code |} is the caret. */
final class AnalysisTest {
  private static final String STATION =
      """
      # Moves the part.
      # Slowly.
      def place(target, height=0.1):
        movel(target)
      end
      def prog():
        speed = 1
        thread watch():
          global seen = 1
          sync()
        end
        if speed > 0:
          place(1)
        else:
          halt
        end
        $ 1 "label"
      end
      """;

  @Test
  void aSyntaxErrorHidesNoMistakeElsewhere() {
    assertEquals(
        List.of("unclosed-string", "unknown-function"),
        codes("def prog():\n  x = \"a\n  zzz()\nend\n"));
    assertEquals(List.of("unknown-function"), codes("def prog():\n  zzz()\nend\n"));
    assertEquals(
        List.of("missing-end", "unknown-function", "too-many-arguments", "unknown-variable"),
        codes(
            """
            def prog():
              height = 1
              while True:
                set_digtal_out(1, True)
                sleep(1, 2, 3)
                movej(heigth)
            end
            """));
  }

  @Test
  void whatAnUnreadStatementMayMeanIsNoMistakeOfOthers() {
    // each name gets its meaning where the text cannot be read
    assertEquals(List.of("syntax-error"), codes("def prog():\n  x = (1\n  sleep(x)\nend\n"));
    assertEquals(List.of("syntax-error"), codes("def f(y z):\n  sleep(y)\nend\nf(1)\n"));
    assertEquals(List.of("syntax-error"), codes("def prog():\n  global g 1\n  sleep(g)\nend\n"));
  }

  @Test
  void aMistakeInALineThatCannotBeReadIsToldOnce() {
    assertEquals(List.of("syntax-error"), codes("def prog():\n  sleep(1 2, 3, zzz\nend\n"));
  }

  @Test
  void theParameterBeingTypedIsActive() {
    assertEquals("movej q", help("movej(|"));
    assertEquals("movej q", help("movej([0, 1|, 2]"));
    assertEquals("movej a", help("movej(q0, |)"));
    assertEquals("movej v", help("movej(q0, v=1|)"));
    assertEquals("sleep t", help("movej(sleep(|), 2)"));
    assertEquals("movej a", help("movej(sleep(1), |2)"));
    assertEquals("sleep -", help("sleep(1, |"));
    assertEquals("place height", help("place(1,|\n  x = 1"));
  }

  @Test
  void outsideOfCallsThereIsNoHelp() {
    assertEquals("none", help("movej(1)|"));
    assertEquals("none", help("x = (1 + |2)"));
    assertEquals("none", help("sleep(1\n  x = |2"));
    assertEquals("none", help("zzz(|)"));
  }

  @Test
  void methodsHaveHelpByTheirReceiver() {
    assertEquals("append element", help("l = [1]\n  l.append(|)"));
  }

  @Test
  void helpShowsUnitsAndDefaults() {
    Marked marked = Marked.of("movej(q, |)");
    SignatureHelp help = marked.analysis().signatureHelp(marked.caret()).orElseThrow();
    assertEquals("rad/s²", help.activeParameter().orElseThrow().unit().symbol());
    assertEquals("1.4", help.activeParameter().orElseThrow().defaultText());
    assertEquals(new SourceRange(0, 5), help.callee());
  }

  @Test
  void builtInsAreExplainedWithUnitsAndSection() {
    Hover hover = hover("def prog():\n  mov|ej([0,0,0,0,0,0])\nend\n");
    assertEquals("movej(q, a=1.4, v=1.05)", hover.head());
    assertEquals(
        """
        Moves all joints to a goal. More is in the manual.
        q: pose or list of 6 numbers
        a: number in rad/s², default 1.4
        v: number in rad/s, default 1.05
        Manual 15.29\
        """,
        hover.text());
    assertEquals(new SourceRange(14, 19), hover.range());
  }

  @Test
  void deprecatedBuiltInsNameTheirSuccessor() {
    assertTrue(
        hover("def prog():\n  set_digital_out|(1, True)\nend\n")
            .text()
            .contains("Deprecated: use set_standard_digital_out."));
  }

  @Test
  void functionsShowTheCommentAboveThem() {
    Hover hover = hover(STATION.replace("  place(1)", "  pla|ce(1)"));
    assertEquals("def place(target, height=0.1)", hover.head());
    assertEquals("Moves the part.\nSlowly.\nDefined on line 3.", hover.text());
  }

  @Test
  void variablesShowTheirKindAndOrigin() {
    Hover hover = hover(STATION.replace("if speed", "if sp|eed"));
    assertEquals("global speed", hover.head());
    assertEquals("Holds a number.\nFirst assigned on line 7.", hover.text());
    Hover local = hover("def prog():\n  def f():\n    local |s = \"a\"\n  end\n  f()\nend\n");
    assertEquals("local s", local.head());
    assertEquals("Holds a string.\nFirst assigned on line 3.", local.text());
  }

  @Test
  void parametersNameTheirFunctionAndDefault() {
    Hover hover = hover(STATION.replace("hei", "hei|"));
    assertEquals("parameter height of place", hover.head());
    assertEquals("Default 0.1.", hover.text());
    assertEquals(
        "a: number in rad/s², default 1.4",
        hover("def prog():\n  movej([0,0,0,0,0,0], |a=1)\nend\n").text());
  }

  @Test
  void commentsAndDefaultsAreShownAsTheyWereTyped() {
    Hover hover = hover("# \u00D6ffnet\ndef o|pen(name=\"\u00F6\"):\nend\n");
    assertEquals("def open(name=\"\u00F6\")", hover.head());
    assertEquals("Defined on line 2.", hover.text().lines().toList().get(1));
    assertEquals("\u00D6ffnet", hover.text().lines().toList().getFirst());
  }

  @Test
  void unknownNamesAreSaidToBe() {
    assertEquals(
        "Nothing defines or assigns this name.", hover("def prog():\n  zz|z()\nend\n").text());
  }

  @Test
  void theOutlineNestsDefinitionsAndShowsGlobalsWhereTheyBegin() {
    assertEquals(
        """
        FUNCTION place(target, height=0.1)
        FUNCTION prog()
          GLOBAL speed
          THREAD watch()
            GLOBAL seen
        """,
        tree(Marked.analysis(STATION).outline(), ""));
  }

  @Test
  void theOutlineOfABrokenTextHasWhatCanBeRead() {
    assertEquals(
        "FUNCTION a()\nFUNCTION b()\n",
        tree(Marked.analysis("def a():\n  x = (\nend\ndef b():\n").outline(), ""));
  }

  @Test
  void blocksBranchesAndCommentsFold() {
    assertEquals(
        List.of(
            "COMMENT 1-2", "BLOCK 3-5", "BLOCK 6-18", "BLOCK 8-11", "BLOCK 12-13", "BLOCK 14-16"),
        Marked.analysis(STATION).folding().stream()
            .map(fold -> fold.kind() + " " + fold.startLine() + "-" + fold.endLine())
            .toList());
  }

  @Test
  void breakpointsStandOnStatementsThatRun() {
    assertEquals(
        List.of(4, 7, 9, 10, 12, 13, 15), List.copyOf(Marked.analysis(STATION).breakpointLines()));
  }

  @Test
  void theSmallestStatementOfALineIsFound() {
    ScriptAnalysis analysis = Marked.analysis("def f():\n  movej([0,\n    1])\n\nend\n");
    assertEquals("movej([0,\n    1])", statement(analysis, 3));
    assertEquals("movej([0,\n    1])", statement(analysis, 2));
    assertTrue(statement(analysis, 4).startsWith("def f()"));
    assertEquals(Optional.empty(), Marked.analysis("# only\n").enclosingStatement(1));
  }

  @Test
  void offsetsOutsideTheTextAreRefused() {
    ScriptAnalysis analysis = Marked.analysis("x = 1");
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> analysis.hover(6));
    assertEquals("offset 6 is outside the text, expected 0 to 5", refused.getMessage());
  }

  private static String statement(ScriptAnalysis analysis, int line) {
    return analysis.source().text(analysis.enclosingStatement(line).orElseThrow());
  }

  private static List<String> codes(String text) {
    return Marked.analysis(text).diagnostics().stream().map(Diagnostic::code).toList();
  }

  private static String help(String body) {
    Marked marked =
        Marked.of("def place(target, height=1):\nend\ndef prog():\n  " + body + "\nend\n");
    return marked
        .analysis()
        .signatureHelp(marked.caret())
        .map(
            help ->
                help.signature().name()
                    + " "
                    + help.activeParameter().map(parameter -> parameter.name()).orElse("-"))
        .orElse("none");
  }

  private static Hover hover(String text) {
    Marked marked = Marked.of(text);
    return marked.analysis().hover(marked.caret()).orElseThrow();
  }

  private static String tree(List<OutlineItem> items, String indentation) {
    StringBuilder tree = new StringBuilder();
    for (OutlineItem item : items) {
      tree.append(indentation + item.kind() + " " + item.name() + item.detail() + "\n");
      tree.append(tree(item.children(), indentation + "  "));
    }
    return tree.toString();
  }
}
