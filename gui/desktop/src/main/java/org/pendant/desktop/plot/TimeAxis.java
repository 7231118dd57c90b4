package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.function.Supplier;
import javax.swing.JPanel;
import org.pendant.kit.theme.Palette;

/** Time axis: the axis of robot time below all charts. */
@SuppressWarnings("serial") // never written to a stream
final class TimeAxis extends JPanel {
  private final PlotPresenter presenter;
  private final Supplier<Rectangle> area;

  /**
   * An axis below an area.
   *
   * @param area where the lines are, in the coordinates of this component
   */
  TimeAxis(PlotPresenter presenter, Supplier<Rectangle> area) {
    this.presenter = presenter;
    this.area = area;
    setName("plot-time-axis");
    setToolTipText(text("robotTimeInSeconds"));
    getAccessibleContext().setAccessibleName(text("robotTimeInSeconds"));
  }

  /** The numbers that fit below an area of this width. */
  static Scale scale(TimeWindow window, int width, FontMetrics metrics) {
    int most = Math.max(1, width / (2 * metrics.stringWidth("0000.0")));
    return Scale.exact(window.beginS(), window.endS(), most);
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(0, getFontMetrics(getFont()).getHeight() + 8);
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    Graphics2D pen = (Graphics2D) g.create();
    TextPainting.smooth(pen);
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle lines = area.get();
    TimeWindow window = presenter.window();
    pen.setColor(Palette.quiet());
    Scale scale = scale(window, lines.width, metrics);
    int free = lines.x + lines.width - metrics.stringWidth("s");
    for (double tick : scale.ticks()) {
      String text = scale.text(tick);
      int width = metrics.stringWidth(text);
      int x = lines.x + (int) Math.round(window.placeOf(tick) * lines.width) - width / 2;
      if (tick >= 0 && x >= 0 && x + width < free - 4) {
        pen.drawString(text, x, metrics.getAscent() + 4);
      }
    }
    pen.drawString("s", free, metrics.getAscent() + 4);
    pen.dispose();
  }
}
