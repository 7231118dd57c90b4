package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.Map;
import java.util.Optional;
import javax.swing.JPanel;

/**
 * Heat bar: beside the numbers of the lines, the more time a line took the warmer. It is there also
 * before the first run, so that the text does not move then.
 */
@SuppressWarnings("serial") // never written to a stream
final class HeatBar extends JPanel {
  private static final int WIDTH = 6;

  private final ScriptArea area;
  private final transient LineNotes notes;

  HeatBar(ScriptArea area, LineNotes notes) {
    this.area = area;
    this.notes = notes;
    setName("heat-bar");
    getAccessibleContext().setAccessibleName(text("shareOfTheTimeOfThe"));
    setToolTipText("");
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(UIScale.scale(WIDTH), area.getPreferredSize().height);
  }

  @Override
  protected void paintComponent(Graphics g) {
    g.setColor(area.getBackground());
    g.fillRect(0, 0, getWidth(), getHeight());
    Rectangle clip = g.getClipBounds();
    for (Map.Entry<Integer, LineNote> each : notes.all().entrySet()) {
      Optional<Rectangle> place = place(each.getKey());
      if (place.isPresent() && place.get().intersects(clip)) {
        Rectangle bar = place.get();
        g.setColor(each.getValue().heatColour());
        g.fillRect(bar.x, bar.y, bar.width, bar.height);
      }
    }
  }

  private Optional<Rectangle> place(int line) {
    if (line > area.getLineCount() || area.getFoldManager().isLineHidden(line - 1)) {
      return Optional.empty();
    }
    Rectangle text = area.place(area.line(line).start());
    int edge = UIScale.scale(1);
    return Optional.of(new Rectangle(edge, text.y, getWidth() - 2 * edge, text.height));
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int line = area.lineAt(area.viewToModel2D(new Point(0, event.getY())));
    LineNote note = notes.all().get(line);
    return note == null ? null : note.heat();
  }
}
