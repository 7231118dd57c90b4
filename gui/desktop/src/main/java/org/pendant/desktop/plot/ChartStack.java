package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;

/**
 * Chart stack: the charts below each other with one axis of time; quantities dropped beside them
 * get a new one.
 */
@SuppressWarnings("serial") // never written to a stream
final class ChartStack extends JPanel {
  private final PlotPresenter presenter;
  private final Runnable changed;
  private final Sheet sheet = new Sheet();
  private final TimeAxis axis;
  private final List<ChartCard> cards = new ArrayList<>();

  /**
   * The charts of a presenter.
   *
   * @param changed runs when time span or cursors have changed
   */
  ChartStack(PlotPresenter presenter, Runnable changed) {
    super(new BorderLayout());
    this.presenter = presenter;
    this.changed = changed;
    axis =
        new TimeAxis(
            presenter, () -> ChartPanel.area(this, sheet.getWidth(), ChartPanel.MIN_HEIGHT));
    JScrollPane scroll = new JScrollPane(sheet);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    add(scroll, BorderLayout.CENTER);
    add(axis, BorderLayout.SOUTH);
    sheet.setTransferHandler(QuantityTransfer.to(presenter.quantities(), this::addChart));
    rebuild();
  }

  private void addChart(List<ChartQuantity> dropped) {
    presenter.addChart(dropped.getFirst());
    Chart chart = presenter.charts().getLast();
    dropped.forEach(each -> presenter.addTo(chart, each));
    rebuild();
  }

  /** Shows charts that have come and gone. */
  void rebuild() {
    sheet.removeAll();
    cards.clear();
    for (Chart chart : presenter.charts()) {
      ChartCard card = new ChartCard(presenter, chart, this::rebuild, changed);
      cards.add(card);
      sheet.add(card, "grow, push, hmin " + ChartPanel.MIN_HEIGHT);
    }
    if (cards.isEmpty()) {
      JLabel note = new JLabel(text("doubleClickAQuantityInThe"), SwingConstants.CENTER);
      note.setEnabled(false);
      note.setName("plot-empty");
      sheet.add(note, "grow, push");
    }
    axis.setVisible(!cards.isEmpty());
    sheet.revalidate();
    refresh();
  }

  /**
   * Shows the newest values and lines: all charts and the axis are one piece of the screen, so that
   * none of them shows another moment than the others while a busy machine still draws those.
   */
  void refresh() {
    cards.forEach(ChartCard::refresh);
    repaint();
  }

  /** As wide and, if the charts fit, as high as what is in sight. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Sheet extends JPanel implements Scrollable {
    Sheet() {
      super(new MigLayout("insets 0, gap 0, wrap, fill", "[grow,fill]"));
      setName("plot-charts");
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
      return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
      return 2 * getFontMetrics(getFont()).getHeight();
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
      return visible.height;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
      return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
      return getParent().getHeight() >= getMinimumSize().height;
    }
  }
}
