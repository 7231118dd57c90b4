package org.pendant.desktop.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.kit.theme.Palette;

/** Execution band: lies over the line where the program is, with the note after that line. */
final class ExecutionBand {
  private static final int MIN_WIDTH = 60;

  private final ScriptArea area;
  private Execution execution = Execution.NONE;
  private Optional<Position> at = Optional.empty();
  private Optional<Object> band = Optional.empty();
  private Rectangle painted = new Rectangle();

  ExecutionBand(ScriptArea area) {
    this.area = area;
  }

  void set(Execution wanted) {
    execution = wanted;
    at = Optional.empty();
    if (wanted.line() >= 1 && wanted.line() <= area.getLineCount()) {
      try {
        at = Optional.of(area.getDocument().createPosition(area.line(wanted.line()).start()));
      } catch (BadLocationException e) {
        throw new IllegalStateException("line " + wanted.line() + " is in the text", e);
      }
    }
    refresh();
  }

  /** Paints the band again, in the present theme. */
  void refresh() {
    band.ifPresent(area::removeLineHighlight);
    band = Optional.empty();
    // the band of the line that runs must not lie under that of the caret
    area.setHighlightCurrentLine(at.isEmpty());
    area.repaint(painted);
    if (at.isEmpty()) {
      return;
    }
    int line = area.lineAt(at.get().getOffset());
    EditorColors colors = EditorColors.now();
    Color color =
        execution.state() == Execution.State.FAILED ? colors.failedLine() : colors.executionLine();
    try {
      band = Optional.of(area.addLineHighlight(line - 1, color));
    } catch (BadLocationException e) {
      throw new IllegalStateException("line " + line + " is in the text", e);
    }
    area.repaint(noteLine());
  }

  /** Paints the note behind its line, as much of it as there is room for. */
  void paintNote(Graphics g) {
    if (execution.note().isEmpty() || at.isEmpty()) {
      painted = new Rectangle();
      return;
    }
    TextSpan line = area.line(area.lineAt(at.get().getOffset()));
    Rectangle end = area.place(line.end());
    Rectangle seen = area.getVisibleRect();
    FontMetrics metrics = area.getFontMetrics(area.getFont());
    int gap = UIScale.scale(16);
    int x = Math.max(end.x + gap, seen.x + gap);
    int room = seen.x + seen.width - x - gap;
    if (room < UIScale.scale(MIN_WIDTH)) {
      painted = new Rectangle();
      return;
    }
    String text = fitting(execution.note().replace('\n', ' '), metrics, room);
    painted =
        new Rectangle(x - gap / 2, end.y, metrics.stringWidth(text) + gap, metrics.getHeight());
    boolean failed = execution.state() == Execution.State.FAILED;
    Color color = failed ? Palette.error() : Palette.quiet();
    Graphics2D pen = area.pen(g);
    pen.setFont(area.getFont());
    pen.setColor(color);
    pen.drawString(text, x, end.y + metrics.getAscent());
    pen.dispose();
  }

  /** The line that its note stands behind; 0 for none. */
  int noted() {
    return execution.note().isEmpty() || at.isEmpty() ? 0 : area.lineAt(at.get().getOffset());
  }

  private Rectangle noteLine() {
    Rectangle place = area.place(at.orElseThrow().getOffset());
    return new Rectangle(0, place.y, area.getWidth(), place.height);
  }

  /** The whole note, where the pointer is on it. */
  Optional<String> tip(Point at) {
    return painted.contains(at) && !execution.note().isEmpty()
        ? Optional.of(RichText.of(execution.note()))
        : Optional.empty();
  }

  private static String fitting(String text, FontMetrics metrics, int room) {
    if (metrics.stringWidth(text) <= room) {
      return text;
    }
    int length = text.length();
    while (length > 0 && metrics.stringWidth(text.substring(0, length) + "\u2026") > room) {
      length--;
    }
    return text.substring(0, length) + "\u2026";
  }
}
