package org.pendant.editors.lsp;

import java.util.Optional;
import java.util.zip.CRC32;
import org.eclipse.lsp4j.DocumentDiagnosticReport;
import org.eclipse.lsp4j.RelatedFullDocumentDiagnosticReport;
import org.eclipse.lsp4j.RelatedUnchangedDocumentDiagnosticReport;
import org.pendant.editors.lsp.provider.DiagnosticAnswers;
import org.pendant.editors.lsp.text.Document;

/** Diagnostic reports: what is wrong in a text, for clients that ask for it. */
final class DiagnosticReports {

  /** A report of {@code document}, a short one if the client has that of the same text already. */
  DocumentDiagnosticReport of(Document document, Optional<String> previous) {
    String id = id(document);
    if (previous.equals(Optional.of(id))) {
      return new DocumentDiagnosticReport(new RelatedUnchangedDocumentDiagnosticReport(id));
    }
    RelatedFullDocumentDiagnosticReport report =
        new RelatedFullDocumentDiagnosticReport(DiagnosticAnswers.of(document));
    report.setResultId(id);
    return new DocumentDiagnosticReport(report);
  }

  /** A name for what is wrong in a text: what is wrong follows from the text alone. */
  static String id(Document document) {
    CRC32 sum = new CRC32();
    sum.update(document.source().bytes());
    return Long.toHexString(sum.getValue()) + "-" + document.source().text().length();
  }
}
