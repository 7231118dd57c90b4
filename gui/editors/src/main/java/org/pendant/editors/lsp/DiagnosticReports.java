package org.pendant.editors.lsp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.zip.CRC32;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DocumentDiagnosticReport;
import org.eclipse.lsp4j.RelatedFullDocumentDiagnosticReport;
import org.eclipse.lsp4j.RelatedUnchangedDocumentDiagnosticReport;
import org.pendant.editors.dryrun.DryRunResult;
import org.pendant.editors.lsp.provider.ClientFeatures;
import org.pendant.editors.lsp.provider.DiagnosticAnswers;
import org.pendant.editors.lsp.provider.DryRunAnswers;
import org.pendant.editors.lsp.text.Document;

/** Diagnostic reports: what is wrong in an open text, by the language and by its dry run. */
final class DiagnosticReports {
  private final ServerSession session;
  private final DryRuns dryRuns;

  DiagnosticReports(ServerSession session, DryRuns dryRuns) {
    this.session = session;
    this.dryRuns = dryRuns;
  }

  /** What is wrong in {@code document}, as far as it is known by now. */
  List<Diagnostic> of(Document document) {
    ClientFeatures client = session.features();
    List<Diagnostic> all = new ArrayList<>(DiagnosticAnswers.of(document, client));
    dryRuns
        .of(document)
        .ifPresent(result -> all.addAll(DryRunAnswers.diagnostics(document, result, client)));
    return all;
  }

  /** A report of {@code document}, a short one if the client knows all of it already. */
  DocumentDiagnosticReport report(Document document, Optional<String> previous) {
    Optional<DryRunResult> result = dryRuns.of(document);
    String id = id(document) + (result.isPresent() ? "-run" : "");
    if (previous.equals(Optional.of(id))) {
      return new DocumentDiagnosticReport(new RelatedUnchangedDocumentDiagnosticReport(id));
    }
    RelatedFullDocumentDiagnosticReport report =
        new RelatedFullDocumentDiagnosticReport(of(document));
    report.setResultId(id);
    return new DocumentDiagnosticReport(report);
  }

  /** The report of a text that is not open. */
  static DocumentDiagnosticReport nothing() {
    return new DocumentDiagnosticReport(new RelatedFullDocumentDiagnosticReport(List.of()));
  }

  /** A name for a text, by what it says. */
  static String id(Document document) {
    CRC32 sum = new CRC32();
    sum.update(document.source().bytes());
    return Long.toHexString(sum.getValue()) + "-" + document.source().text().length();
  }
}
