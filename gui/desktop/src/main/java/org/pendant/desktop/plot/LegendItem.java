package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Legend item: one line's colour, name and value, and the button that removes it. */
@SuppressWarnings("serial") // never written to a stream
final class LegendItem extends JPanel {
  private final ChartTrace trace;
  private final String common;
  private final JLabel name;
  private final JLabel value = new JLabel();
  private int widest;

  /**
   * An item.
   *
   * @param common what stands before all items, and not in this one again; may be empty
   */
  LegendItem(ChartTrace trace, String common, Runnable remove) {
    super(new MigLayout("insets 0, gap 4", "[][][]"));
    this.trace = trace;
    this.common = common;
    setOpaque(false);
    String title = trace.quantity().namedLabel();
    name = new JLabel(Legend.below(common, title), new Swatch(trace.color()), JLabel.LEADING);
    name.setToolTipText(Messages.joined(List.of(title, trace.quantity().id())));
    value.setName("plot-value-" + trace.quantity().id());
    value.setToolTipText(text("valueOf", title));
    value.putClientProperty("FlatLaf.styleClass", "monospaced");
    JButton close = new JButton("\u00d7");
    close.setName("plot-remove-" + trace.quantity().id());
    close.setToolTipText(text("remove", title));
    close.getAccessibleContext().setAccessibleName(text("remove", title));
    close.putClientProperty("JButton.buttonType", "toolBarButton");
    close.putClientProperty("FlatLaf.style", "toolbar.margin: 0,3,0,3");
    close.addActionListener(event -> remove.run());
    add(name);
    add(value);
    add(close, "gapleft 0");
  }

  /** Shows a value; room once taken is kept, so that the legend does not jump. */
  void show(PlotPresenter presenter) {
    String title = Legend.below(common, trace.quantity().namedLabel());
    if (!title.equals(name.getText())) {
      name.setText(title);
    }
    String text = presenter.legend(trace.quantity());
    if (text.length() > widest || text.length() < widest - 12) {
      widest = text.length();
    }
    String padded = " ".repeat(Math.max(0, widest - text.length())) + text;
    if (!padded.equals(value.getText())) {
      value.setText(padded);
    }
  }

  private record Swatch(int color) implements Icon {
    @Override
    public int getIconWidth() {
      return 16;
    }

    @Override
    public int getIconHeight() {
      return 12;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
      Graphics2D pen = (Graphics2D) g.create();
      pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      pen.setColor(Palette.series(color));
      pen.setStroke(ChartPainter.swatch(color));
      pen.draw(new Line2D.Double(x + 1.5, y + 6, x + 14.5, y + 6));
      pen.dispose();
    }
  }
}
