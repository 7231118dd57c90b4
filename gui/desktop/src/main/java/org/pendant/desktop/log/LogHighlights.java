package org.pendant.desktop.log;

import java.awt.Color;
import javax.swing.JTextArea;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter.DefaultHighlightPainter;

/** Log highlights: marks what is looked for in a text. */
final class LogHighlights {
  /** More are no help. */
  private static final int MOST = 500;

  private final JTextArea area;
  private TextSearch search = TextSearch.NONE;

  LogHighlights(JTextArea area) {
    this.area = area;
  }

  /** Looks for something else from now on. */
  void mark(TextSearch wanted) {
    if (!wanted.equals(search)) {
      search = wanted;
      show();
    }
  }

  /** Marks it in the text as it is now. */
  void show() {
    area.getHighlighter().removeAllHighlights();
    String text = area.getText();
    Color color = LogColors.mark();
    int at = search.find(text, 0);
    for (int i = 0; at >= 0 && i < MOST; i++) {
      int end = at + search.wanted().length();
      try {
        area.getHighlighter().addHighlight(at, end, new DefaultHighlightPainter(color));
      } catch (BadLocationException e) {
        throw new AssertionError("found in this very text", e);
      }
      at = search.find(text, end);
    }
  }
}
