package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.language.source.Diagnostic;

/** The first fix of the first diagnostic of each example, applied. */
@Tag("slow")
final class QuickFixTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      quoteCharacter = '`',
      value = {
        "unknown-function ~ mvoej([0,0,0,0,0,0])   ~ movej([0,0,0,0,0,0])",
        "unknown-function ~ set_digtal_out(1, True) ~ set_standard_digital_out(1, True)",
        "unknown-function ~ set_analg_out(1)       ~ set_analog_out(1)",
        "unknown-variable ~ count = 1\\nx = coutn  ~ count = 1\\nx = count",
        "unknown-variable ~ x = TRUE               ~ x = True",
        "unknown-variable ~ x = get_actual_tcp_pose ~ x = get_actual_tcp_pose()",
        "unknown-argument ~ sleep(tt=1)            ~ sleep(t=1)",
        "unknown-method   ~ l = [1]\\nl.apend(2)   ~ l = [1]\\nl.append(2)",
        "deprecated       ~ set_digital_out(1, True) ~ set_standard_digital_out(1, True)",
        "no-effect        ~ sync                   ~ sync()",
        "not-a-function   ~ thread t():\\nend\\nt() ~ thread t():\\nend\\nrun t()",
        "not-a-thread     ~ run sync()             ~ sync()",
        "thread-arguments ~ thread t():\\nend\\nrun t(1, 2) ~ thread t():\\nend\\nrun t()",
        "thread-parameters ~ thread t(a, b):\\nend  ~ thread t():\\nend",
        "semicolon        ~ sync();                ~ sync()",
        "comment          ~ sync() // waits        ~ sync() # waits",
        "single-quotes    ~ textmsg('a b')         ~ textmsg(\"a b\")",
        "unclosed-string  ~ textmsg(\"a b)         ~ textmsg(\"a b\")",
        "unclosed-string  ~ x = \"a b              ~ x = \"a b\"",
        "and-sign         ~ x = 1\\ny = x&&x       ~ x = 1\\ny = x and x",
        "or-sign          ~ x = 1\\ny = x || x     ~ x = 1\\ny = x or x",
        "unequal-sign     ~ x = 1 <> 2             ~ x = 1 != 2",
        "colon-assign     ~ x := 1                 ~ x = 1",
        "arithmetic-assign ~ x = 1\\nx += 2        ~ x = 1\\nx = x + 2",
        "arithmetic-assign ~ x = 1\\nx *= 2 - 1 # c ~ x = 1\\nx = x * (2 - 1) # c",
        "else-if          ~ if 1:\\nelse if 2:\\nend ~ if 1:\\nelif 2:\\nend",
        "else-if          ~ if 1:\\nelseif 2:\\nend ~ if 1:\\nelif 2:\\nend",
        "end-word         ~ if 1:\\nendif          ~ if 1:\\nend",
        "function-word    ~ function f():\\nend    ~ def f():\\nend",
        "word-case        ~ IF 1:\\nend            ~ if 1:\\nend",
        "missing-colon    ~ if 1\\n  sync()\\nend  ~ if 1:\\n  sync()\\nend",
        "syntax-error     ~ if x = 1:\\nend        ~ if x == 1:\\nend",
        "syntax-error     ~ x == 1                 ~ x = 1",
        "syntax-error     ~ x = 1\\nx++            ~ x = 1\\nx = x + 1",
        "syntax-error     ~ x = \"a\" \"b\"        ~ x = \"a\" + \"b\"",
        "syntax-error     ~ sync())                ~ sync()",
        "syntax-error     ~ sleep(1\\nsync()       ~ sleep(1)\\nsync()",
        "syntax-error     ~ x = [1, 2\\nsync()     ~ x = [1, 2]\\nsync()",
        "syntax-error     ~ if (1 == 2:\\nend      ~ if (1 == 2):\\nend",
        "syntax-error     ~ def f:\\nend           ~ def f():\\nend",
      })
  void aMistakeIsPutRight(String code, String wrong, String right) {
    String text = program(wrong);
    ScriptAnalysis before = Marked.analysis(text);
    Diagnostic diagnostic = diagnostic(before, code);
    List<QuickFix> fixes = before.fixes(diagnostic);
    assertFalse(fixes.isEmpty(), () -> "no fix for " + diagnostic);
    String fixed = TextEdit.apply(before.source(), fixes.getFirst().edits()).text();
    assertEquals(program(right), fixed);
    assertTrue(
        Marked.analysis(fixed).diagnostics().stream().noneMatch(other -> other.code().equals(code)),
        fixed);
  }

  @Test
  void aMissingEndGoesBelowTheLinesThatStandFurtherIn() {
    assertFixed(
        "missing-end",
        "def prog():\n  while True:\n    sync()\n\n  sync()\nend\n",
        "def prog():\n  while True:\n    sync()\n  end\n\n  sync()\nend\n");
  }

  @Test
  void aMissingEndOfTheProgramGoesToItsEnd() {
    assertFixed("missing-end", "def prog():\n  sync()\n", "def prog():\n  sync()\nend\n");
    assertFixed("missing-end", "def prog():\nsync()\n", "def prog():\nsync()\nend\n");
  }

  @Test
  void aStrayEndGoesWithItsLine() {
    assertFixed("stray-end", "def prog():\n  sync()\nend\nend\n", "def prog():\n  sync()\nend\n");
  }

  @Test
  void aCallBehindTheProgramGoesWithItsLine() {
    assertFixed(
        "trailing-call", "def prog():\n  sync()\nend\nprog()\n", "def prog():\n  sync()\nend\n");
  }

  @Test
  void theNearestNameIsNamedInTheTitle() {
    ScriptAnalysis analysis = Marked.analysis(program("slep(1)"));
    assertEquals(
        "Replace by sleep", analysis.fixes(analysis.diagnostics().getFirst()).getFirst().title());
  }

  @Test
  void aDeprecatedFunctionWithoutSuccessorHasNoFix() {
    assertNoFix("deprecated", "set_analog_out(1)");
  }

  @Test
  void nothingIsOfferedForNamesNearNothing() {
    assertNoFix("unknown-function", "zzzzzzzz()");
  }

  @Test
  void aFunctionThatNeedsArgumentsIsNotCalledWithout() {
    assertNoFix("unknown-variable", "x = movej");
  }

  @Test
  void anExampleThatOneStepDoesNotMendIsLeftAlone() {
    assertNoFix("syntax-error", "x = = 1");
  }

  private static void assertNoFix(String code, String body) {
    ScriptAnalysis analysis = Marked.analysis(program(body));
    assertEquals(List.of(), analysis.fixes(diagnostic(analysis, code)));
  }

  private static void assertFixed(String code, String text, String expected) {
    ScriptAnalysis analysis = Marked.analysis(text);
    QuickFix fix = analysis.fixes(diagnostic(analysis, code)).getFirst();
    assertEquals(expected, TextEdit.apply(analysis.source(), fix.edits()).text());
  }

  private static Diagnostic diagnostic(ScriptAnalysis analysis, String code) {
    return analysis.diagnostics().stream()
        .filter(other -> other.code().equals(code))
        .findFirst()
        .orElseThrow(() -> new AssertionError(code + " is not in " + analysis.diagnostics()));
  }

  private static String program(String body) {
    return "def prog():\n" + body.replace("\\n", "\n") + "\nend\n";
  }
}
