package org.pendant.desktop.plot;

import java.awt.BorderLayout;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;

/** Chart card: a chart with its legend above. */
@SuppressWarnings("serial") // never written to a stream
final class ChartCard extends JPanel {
  private final PlotPresenter presenter;
  private final Chart chart;
  private final ChartPanel panel;
  private final List<LegendItem> items = new ArrayList<>();

  /**
   * A chart.
   *
   * @param rebuild runs when quantities have come or gone
   * @param changed runs when time span or cursors have changed
   */
  ChartCard(PlotPresenter presenter, Chart chart, Runnable rebuild, Runnable changed) {
    super(new BorderLayout());
    this.presenter = presenter;
    this.chart = chart;
    panel = new ChartPanel(presenter, chart, changed);
    JPanel legend = new JPanel(new WrappingRow(4));
    legend.setName("plot-legend");
    String common =
        Legend.common(chart.traces().stream().map(each -> each.quantity().namedLabel()).toList());
    if (!common.isEmpty()) {
      JLabel heading = new JLabel(common);
      heading.setForeground(Palette.quiet());
      legend.add(heading);
    }
    for (ChartTrace trace : chart.traces()) {
      LegendItem item =
          new LegendItem(
              trace,
              common,
              () -> {
                presenter.remove(chart, trace.quantity());
                rebuild.run();
              });
      items.add(item);
      legend.add(item);
    }
    add(legend, BorderLayout.NORTH);
    add(panel, BorderLayout.CENTER);
    Consumer<List<ChartQuantity>> take =
        dropped -> {
          dropped.forEach(each -> presenter.addTo(chart, each));
          rebuild.run();
        };
    setTransferHandler(QuantityTransfer.to(presenter.quantities(), take));
    panel.setTransferHandler(getTransferHandler());
  }

  Chart chart() {
    return chart;
  }

  /** Where the lines are, in the coordinates of this card. */
  Rectangle area() {
    Rectangle area = panel.area();
    area.translate(panel.getX(), panel.getY());
    return area;
  }

  /** Shows the newest values; the lines are painted with those of the other charts. */
  void refresh() {
    items.forEach(each -> each.show(presenter));
  }
}
