package org.pendant.editors.lsp.provider;

import java.util.List;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.DiagnosticTag;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.VisibleText;

/** Diagnostic answers: what is wrong in a text. */
public final class DiagnosticAnswers {
  /** Who says so, shown beside the message. */
  public static final String SOURCE = "pendant";

  /** The most that are told of one text. */
  public static final int MAX_DIAGNOSTICS = 1000;

  private DiagnosticAnswers() {}

  /** All of {@code document}, the first ones where there are too many. */
  public static List<Diagnostic> of(Document document, ClientFeatures client) {
    return document.analysis().diagnostics().stream()
        .filter(each -> !isImported(document, each))
        .limit(MAX_DIAGNOSTICS)
        .map(each -> diagnostic(document, each, client))
        .toList();
  }

  /** Whether it misses a variable that comes from a script that is imported. */
  private static boolean isImported(
      Document document, org.pendant.language.source.Diagnostic diagnostic) {
    return diagnostic.code().equals("unknown-variable")
        && document
            .imported()
            .filter(names -> names.hasVariable(document.source().text(diagnostic.range())))
            .isPresent();
  }

  static Diagnostic diagnostic(
      Document document, org.pendant.language.source.Diagnostic diagnostic, ClientFeatures client) {
    Diagnostic told =
        new Diagnostic(
            document.range(diagnostic.range()),
            client.shown(VisibleText.of(ByteText.decoded(diagnostic.message()))),
            diagnostic.isError() ? DiagnosticSeverity.Error : DiagnosticSeverity.Warning,
            SOURCE,
            diagnostic.code());
    switch (diagnostic.code()) {
      case "unreachable", "no-effect" -> told.setTags(List.of(DiagnosticTag.Unnecessary));
      case "deprecated" -> told.setTags(List.of(DiagnosticTag.Deprecated));
      default -> {}
    }
    return told;
  }
}
