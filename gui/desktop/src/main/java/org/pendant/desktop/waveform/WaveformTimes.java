package org.pendant.desktop.waveform;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.util.Locale;
import javax.swing.JComponent;
import org.pendant.kit.theme.Palette;

/** Waveform times: the time since the start of the program, above the rows. */
@SuppressWarnings("serial") // never written to a stream
final class WaveformTimes extends JComponent {
  private final transient WaveformCanvas canvas;

  WaveformTimes(WaveformCanvas canvas) {
    this.canvas = canvas;
  }

  @Override
  public Dimension getPreferredSize() {
    int height = getFontMetrics(getFont()).getHeight() + UIScale.scale(6);
    return new Dimension(canvas.getPreferredSize().width, height);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics.create();
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    Rectangle clip = pen.getClipBounds();
    pen.setColor(Palette.card());
    pen.fill(clip);
    pen.setColor(Palette.quiet());
    pen.setFont(getFont());
    double unit = WaveformPainter.gridS(canvas);
    int decimals = unit >= 1 ? 0 : unit >= 0.1 ? 1 : unit >= 0.01 ? 2 : 3;
    for (double i = Math.max(0, Math.floor(canvas.timeAt(clip.x) / unit) - 1);
        canvas.x(i * unit) <= clip.x + clip.width;
        i++) {
      String text = String.format(Locale.ROOT, "%." + decimals + "f s", i * unit);
      pen.drawString(
          text,
          canvas.x(i * unit) + UIScale.scale(3),
          getHeight() - pen.getFontMetrics().getDescent() - UIScale.scale(2));
    }
    pen.dispose();
  }
}
