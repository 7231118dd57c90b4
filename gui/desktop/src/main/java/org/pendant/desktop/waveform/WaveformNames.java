package org.pendant.desktop.waveform;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import org.pendant.kit.theme.Palette;

/** Waveform names: the signals of the rows, at their left. */
@SuppressWarnings("serial") // never written to a stream
final class WaveformNames extends JComponent {
  private final transient WaveformCanvas canvas;
  private final transient WaveformPainter painter;

  WaveformNames(WaveformCanvas canvas, WaveformPainter painter) {
    this.canvas = canvas;
    this.painter = painter;
    setName("waveform-names");
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            canvas.requestFocusInWindow();
            int row = canvas.rowAt(event.getY());
            if (row >= 0) {
              canvas.select(row);
            }
          }
        });
  }

  private List<String> titles() {
    List<String> titles = new ArrayList<>();
    canvas.sheet().rows().forEach(row -> titles.add(painter.title(row.signal())));
    canvas.capture().outputs().forEach(row -> titles.add(painter.title(row.signal())));
    return titles;
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext =
          new AccessibleJComponent() {
            @Override
            public AccessibleRole getAccessibleRole() {
              return AccessibleRole.LABEL;
            }

            @Override
            public String getAccessibleName() {
              return String.join("\n", titles());
            }
          };
    }
    return accessibleContext;
  }

  @Override
  public Dimension getPreferredSize() {
    FontMetrics metrics = getFontMetrics(getFont());
    int width = titles().stream().mapToInt(metrics::stringWidth).max().orElse(0);
    return new Dimension(width + UIScale.scale(24), canvas.getPreferredSize().height);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics.create();
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setColor(Palette.card());
    pen.fill(pen.getClipBounds());
    pen.setFont(getFont());
    FontMetrics metrics = pen.getFontMetrics();
    int height = painter.rowHeight(canvas);
    List<String> titles = titles();
    int inputs = canvas.sheet().rows().size();
    for (int i = 0; i < titles.size(); i++) {
      int y = i * height;
      if (i == canvas.selected() && i < inputs) {
        pen.setColor(Palette.tint(Palette.accent(), 0.2));
        pen.fillRect(0, y, getWidth(), height);
      }
      pen.setColor(i < inputs ? getForeground() : Palette.quiet());
      int base = y + (height + metrics.getAscent() - metrics.getDescent()) / 2;
      pen.drawString(titles.get(i), UIScale.scale(8), base);
    }
    pen.dispose();
  }
}
