package org.pendant.desktop.editor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.folding.Fold;
import org.fife.ui.rsyntaxtextarea.folding.FoldManager;
import org.fife.ui.rsyntaxtextarea.folding.FoldParser;
import org.fife.ui.rsyntaxtextarea.folding.FoldType;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.language.service.FoldingRange;

/** Script folds: tells the text component what can be folded: what the last analysis found. */
final class ScriptFolds implements FoldParser {
  /**
   * The component looks through all folds for every line that it paints: a longer text has none.
   */
  private static final int MAX_LINES = 30_000;

  @Override
  public List<Fold> getFolds(RSyntaxTextArea textArea) {
    if (!(textArea instanceof ScriptArea area)) {
      return List.of();
    }
    if (area.getLineCount() > MAX_LINES) {
      return List.of();
    }
    Optional<AnalysedText> analysed = area.analysed();
    if (analysed.isEmpty()) {
      return present(textArea.getFoldManager());
    }
    try {
      return folds(analysed.get().folding(), textArea);
    } catch (BadLocationException e) {
      throw new IllegalStateException("the folds are not of this text", e);
    }
  }

  /** Between two analyses the folds move with the text. */
  private static List<Fold> present(FoldManager manager) {
    List<Fold> folds = new ArrayList<>();
    for (int i = 0; i < manager.getFoldCount(); i++) {
      folds.add(manager.getFold(i));
    }
    return folds;
  }

  private static List<Fold> folds(List<FoldingRange> ranges, RSyntaxTextArea area)
      throws BadLocationException {
    List<Fold> outermost = new ArrayList<>();
    Deque<Fold> open = new ArrayDeque<>();
    Deque<Integer> ends = new ArrayDeque<>();
    Element lines = area.getDocument().getDefaultRootElement();
    int lastStart = 0;
    for (FoldingRange range : ranges) {
      if (range.startLine() == lastStart || range.endLine() > lines.getElementCount()) {
        continue; // the component folds a line only once
      }
      lastStart = range.startLine();
      while (!ends.isEmpty() && ends.peek() < range.endLine()) {
        ends.pop();
        open.pop();
      }
      int type = range.kind() == FoldingRange.Kind.COMMENT ? FoldType.COMMENT : FoldType.CODE;
      int start = lines.getElement(range.startLine() - 1).getStartOffset();
      Fold fold;
      if (open.isEmpty()) {
        fold = new Fold(type, area, start);
        outermost.add(fold);
      } else {
        fold = open.peek().createChild(type, start);
      }
      fold.setEndOffset(lines.getElement(range.endLine() - 1).getEndOffset() - 1);
      open.push(fold);
      ends.push(range.endLine());
    }
    return outermost;
  }
}
