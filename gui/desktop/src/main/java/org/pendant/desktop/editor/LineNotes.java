package org.pendant.desktop.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.kit.theme.Palette;

/** Line notes: paints what stands behind lines; a line that is too long for that has a tip. */
final class LineNotes {
  private static final int GAP = 16;

  private final ScriptArea area;
  private final Map<Integer, Rectangle> painted = new HashMap<>();
  private Map<Integer, LineNote> notes = Map.of();

  LineNotes(ScriptArea area) {
    this.area = area;
  }

  /** Shows these, by their lines from 1. */
  void set(Map<Integer, LineNote> wanted) {
    if (!wanted.equals(notes)) {
      notes = Map.copyOf(wanted);
      area.repaint();
    }
  }

  Map<Integer, LineNote> all() {
    return notes;
  }

  /**
   * Paints those that can be seen.
   *
   * @param without the line that another note stands behind; 0 for none
   */
  void paint(Graphics2D pen, int without) {
    painted.clear();
    if (notes.isEmpty()) {
      return;
    }
    Rectangle seen = area.getVisibleRect();
    int first = area.lineAt(area.viewToModel2D(new Point(0, seen.y)));
    int last = area.lineAt(area.viewToModel2D(new Point(0, seen.y + seen.height)));
    FontMetrics metrics = area.getFontMetrics(area.getFont());
    pen.setFont(area.getFont());
    pen.setColor(Palette.quiet());
    for (int line = first; line <= last; line++) {
      LineNote note = notes.get(line);
      if (note != null && line != without && !area.getFoldManager().isLineHidden(line - 1)) {
        paint(pen, metrics, line, note, seen);
      }
    }
  }

  private void paint(Graphics2D pen, FontMetrics metrics, int line, LineNote note, Rectangle seen) {
    Rectangle end = area.place(area.line(line).end());
    int gap = UIScale.scale(GAP);
    int x = Math.max(end.x + gap, seen.x + gap);
    String text = note.fitting(metrics, seen.x + seen.width - x - gap / 2);
    if (!text.isEmpty()) {
      pen.drawString(text, x, end.y + metrics.getAscent());
      painted.put(
          line, new Rectangle(x - gap / 2, end.y, metrics.stringWidth(text) + gap, end.height));
    }
  }

  /** All of the note under the pointer. */
  Optional<String> tip(Point at) {
    return painted.entrySet().stream()
        .filter(each -> each.getValue().contains(at))
        .map(each -> notes.get(each.getKey()))
        .map(note -> RichText.lines(note.whole()))
        .findFirst();
  }
}
