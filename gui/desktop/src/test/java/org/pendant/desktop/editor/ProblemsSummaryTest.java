package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.SourceRange;

/** How many problems of each kind there are, in words. */
final class ProblemsSummaryTest {
  private static String summary(int errors, int warnings) {
    List<Problem> problems = new ArrayList<>();
    for (int i = 0; i < errors + warnings; i++) {
      Diagnostic.Severity severity =
          i < errors ? Diagnostic.Severity.ERROR : Diagnostic.Severity.WARNING;
      Diagnostic diagnostic = new Diagnostic("code", severity, new SourceRange(0, 1), "m", "m");
      problems.add(new Problem(diagnostic, new TextSpan(0, 1), 1, 1, "m"));
    }
    return ProblemsView.summary(problems);
  }

  @Test
  void noneOneAndSeveralAreSaidDifferently() {
    assertEquals("no errors, no warnings", summary(0, 0));
    assertEquals("1 error, 1 warning", summary(1, 1));
    assertEquals("2 errors, 3 warnings", summary(2, 3));
  }
}
