package org.pendant.language.service;

import java.util.List;
import java.util.stream.Stream;
import org.pendant.language.source.Diagnostic;

/** Quick fixes: proposes fixes for one diagnostic and keeps those that work. */
final class QuickFixes {
  private final ScriptAnalysis analysis;
  private final Diagnostic diagnostic;

  QuickFixes(ScriptAnalysis analysis, Diagnostic diagnostic) {
    this.analysis = analysis;
    this.diagnostic = diagnostic;
  }

  List<QuickFix> working() {
    return Stream.of(
            NameFixes.propose(analysis, diagnostic),
            WordFixes.propose(analysis, diagnostic),
            BlockFixes.propose(analysis, diagnostic))
        .flatMap(List::stream)
        .filter(this::works)
        .toList();
  }

  /** Tries it: the diagnostic must be gone, and no new syntax error may have come. */
  private boolean works(QuickFix fix) {
    ScriptAnalysis after =
        ScriptAnalysis.of(TextEdit.apply(analysis.source(), fix.edits()), analysis.catalogue());
    int place = TextEdit.moved(diagnostic.range().start(), fix.edits());
    boolean stays =
        after.diagnostics().stream()
            .filter(other -> other.code().equals(diagnostic.code()))
            .anyMatch(
                other ->
                    other.range().start() == place
                        || other.range().start() == diagnostic.range().start());
    return !stays && after.syntaxErrors() <= analysis.syntaxErrors();
  }
}
