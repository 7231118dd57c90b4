package org.pendant.editors.lsp.provider;

import java.util.List;
import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeKind;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SelectionRange;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.source.SourceRange;

/** Structure: what can be folded, and what a selection grows to. */
public final class Structure {
  private Structure() {}

  /** What can be folded; the {@code end} of a block stays to be seen. */
  public static List<FoldingRange> folding(Document document) {
    return document.analysis().folding().stream()
        .map(
            range -> {
              boolean closed =
                  document.source().lineText(range.endLine()).strip().startsWith("end");
              int last = range.endLine() - (closed ? 2 : 1);
              FoldingRange told = new FoldingRange(range.startLine() - 1, last);
              if (range.kind() == org.pendant.language.service.FoldingRange.Kind.COMMENT) {
                told.setKind(FoldingRangeKind.Comment);
              }
              return told;
            })
        .filter(told -> told.getEndLine() > told.getStartLine())
        .toList();
  }

  /** What the selection at {@code position} grows to, the innermost first. */
  public static SelectionRange selection(Document document, Position position) {
    SelectionRange around = null;
    List<SourceRange> ranges = document.analysis().enclosing(document.offset(position));
    for (SourceRange range : ranges.reversed()) {
      around = new SelectionRange(document.range(range), around);
    }
    return around == null ? new SelectionRange(new Range(position, position), null) : around;
  }
}
