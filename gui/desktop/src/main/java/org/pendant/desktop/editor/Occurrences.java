package org.pendant.desktop.editor;

import java.awt.Color;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.text.BadLocationException;
import javax.swing.text.Highlighter;
import org.fife.ui.rtextarea.SmartHighlightPainter;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.kit.background.WorkQueue;

/**
 * Occurrences: marks every place that means the same as the name at the caret, after a moment of
 * rest.
 */
final class Occurrences {
  private static final int REST_MS = 250;
  private static final int MOST = 500;

  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final WorkQueue background;
  private final SmartHighlightPainter painter = new SmartHighlightPainter(Color.LIGHT_GRAY);
  private final List<Object> marks = new ArrayList<>();
  private List<TextSpan> marked = List.of();
  private int version;

  Occurrences(ScriptArea area, AnalysisSchedule schedule, WorkQueue background) {
    this.area = area;
    this.schedule = schedule;
    this.background = background;
    area.addCaretListener(event -> caretMoved());
    themeChanged();
  }

  void themeChanged() {
    painter.setPaint(EditorColors.now().bracket());
  }

  private void caretMoved() {
    int asked = ++version;
    if (!marked.isEmpty() && !isOnMark(area.getCaretPosition())) {
      clear();
    }
    background.run(REST_MS, () -> EventQueue.invokeLater(() -> look(asked)));
  }

  /** Whether the caret is still in a name that is marked; marks move with the text. */
  private boolean isOnMark(int caret) {
    return schedule.current().isPresent() && marked.stream().anyMatch(span -> span.touches(caret));
  }

  private void look(int asked) {
    Optional<AnalysedText> analysed = schedule.current();
    if (asked != version || analysed.isEmpty()) {
      return;
    }
    int caret = area.getCaretPosition();
    background.run(
        0,
        () -> {
          List<TextSpan> found = analysed.get().references(caret);
          EventQueue.invokeLater(
              () -> {
                boolean still = schedule.current().filter(now -> now == analysed.get()).isPresent();
                if (asked == version && still) {
                  mark(found);
                }
              });
        });
  }

  /** A name that occurs once needs no mark. */
  private void mark(List<TextSpan> found) {
    List<TextSpan> wanted =
        found.size() < 2 ? List.of() : found.subList(0, Math.min(MOST, found.size()));
    if (wanted.equals(marked)) {
      return;
    }
    clear();
    marked = wanted;
    Highlighter highlighter = area.getHighlighter();
    try {
      for (TextSpan span : wanted) {
        marks.add(highlighter.addHighlight(span.start(), span.end(), painter));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("the names are not of this text", e);
    }
  }

  private void clear() {
    marks.forEach(area.getHighlighter()::removeHighlight);
    marks.clear();
    marked = List.of();
  }
}
