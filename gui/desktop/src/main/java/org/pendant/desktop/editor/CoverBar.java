package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.Map;
import java.util.Optional;
import javax.swing.JPanel;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.kit.theme.Palette;

/**
 * Cover bar: beside the numbers of the lines, what tests have reached of each: a full bar, a
 * hatched one, or an empty frame.
 */
@SuppressWarnings("serial") // never written to a stream
final class CoverBar extends JPanel {
  private static final int WIDTH = 7;
  private static final int STRIPE = 2;

  private final ScriptArea area;
  private transient Map<Integer, LineCover> lines = Map.of();

  CoverBar(ScriptArea area) {
    this.area = area;
    setName("cover-bar");
    getAccessibleContext().setAccessibleName(text("whatTestsHaveReached"));
    setToolTipText("");
    setVisible(false);
  }

  /** Shows these, by their lines from 1. */
  void set(Map<Integer, LineCover> wanted) {
    lines = Map.copyOf(wanted);
    setVisible(!lines.isEmpty());
    repaint();
  }

  /** What is known of a line. */
  Optional<LineCover> line(int number) {
    return Optional.ofNullable(lines.get(number));
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
    int last = lineAt(clip.y + clip.height);
    for (int line = lineAt(clip.y); line <= last; line++) {
      LineCover cover = lines.get(line);
      if (cover != null && !area.getFoldManager().isLineHidden(line - 1)) {
        paint(g, cover, area.place(area.line(line).start()));
      }
    }
  }

  private void paint(Graphics g, LineCover cover, Rectangle text) {
    int edge = UIScale.scale(1);
    int width = getWidth() - 2 * edge;
    int height = text.height - edge;
    g.setColor(color(cover));
    switch (cover.reach()) {
      case ALL -> g.fillRect(edge, text.y, width, text.height);
      case SOME -> {
        int stripe = UIScale.scale(STRIPE);
        for (int y = 0; y < height; y += 2 * stripe) {
          g.fillRect(edge, text.y + y, width, Math.min(stripe, height - y));
        }
      }
      case NONE -> {
        g.fillRect(edge, text.y, width, edge);
        g.fillRect(edge, text.y + height - edge, width, edge);
        g.fillRect(edge, text.y, edge, height);
        g.fillRect(edge + width - edge, text.y, edge, height);
      }
    }
  }

  private static Color color(LineCover cover) {
    if (cover.stale()) {
      return Palette.quiet();
    }
    return switch (cover.reach()) {
      case ALL -> Palette.ok();
      case SOME -> Palette.warning();
      case NONE -> Palette.error();
    };
  }

  private int lineAt(int y) {
    return area.lineAt(area.viewToModel2D(new Point(0, y)));
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    return line(lineAt(event.getY())).map(each -> RichText.lines(each.whole())).orElse(null);
  }
}
