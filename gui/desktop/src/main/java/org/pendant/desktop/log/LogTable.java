package org.pendant.desktop.log;

import java.awt.BorderLayout;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.BoundedRangeModel;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;

/** Log table: the table of messages, and the chip that leads back to the newest one. */
final class LogTable {
  private final LogPresenter presenter;
  private final LogTableModel model;
  private final LogRows table;
  private final JScrollPane scroll;
  private final NewestChip chip = new NewestChip(this::jumpToNewest);
  private final JPanel content;
  private final Runnable selected;
  private final Consumer<LogLine> showSource;
  private int lastValue;
  private int lastMaximum;

  LogTable(
      LogPresenter presenter, LogColumns columns, Runnable selected, Consumer<LogLine> showSource) {
    this.presenter = presenter;
    this.selected = selected;
    this.showSource = showSource;
    model = new LogTableModel(presenter);
    table = new LogRows(model, presenter, columns);
    scroll = new JScrollPane(table);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.getVerticalScrollBar().getModel().addChangeListener(event -> scrolled());
    scroll.getViewport().addComponentListener(new Resizing());
    content = new Floating(scroll, chip);
    table.getSelectionModel().addListSelectionListener(event -> selected.run());
    table.addMouseListener(new Clicking());
    table.addMouseMotionListener(new Clicking());
    key("ENTER", "log-show-source", this::showSelectedSource);
    key("control END", "log-newest", this::jumpToNewest);
    table.prepare();
    table.onFitted(this::stayAtBottom);
  }

  JComponent component() {
    return content;
  }

  void key(String keys, String name, Runnable run) {
    table
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(keys), name);
    table.getActionMap().put(name, LogView.act(run));
  }

  void repaint() {
    table.repaint();
  }

  int selectedRow() {
    int row = table.getSelectionModel().getLeadSelectionIndex();
    return row < model.getRowCount() && table.isRowSelected(row) ? row : -1;
  }

  int[] selectedRows() {
    return table.getSelectedRows();
  }

  void clearSelection() {
    table.clearSelection();
  }

  /** Selects a row and brings it in sight; nothing happens for -1. */
  void select(int row) {
    if (row >= 0) {
      followFrom(row);
      table.getSelectionModel().setSelectionInterval(row, row);
      table.scrollRectToVisible(table.getCellRect(row, 0, true));
      showUnread();
    }
  }

  /** Who chooses a message wants to read it: newer ones do not move it away. */
  private void followFrom(int row) {
    boolean allInSight = table.getPreferredSize().height <= scroll.getViewport().getHeight();
    presenter.follow(allInSight || row == presenter.rows() - 1);
  }

  /** Shows rows that came and went; what is in sight stays there unless the newest is followed. */
  void changed(LogPresenter.Change change) {
    boolean first = change.added() > 0 && change.added() == presenter.rows();
    int gone = change.removed() == 0 ? 0 : table.getCellRect(change.removed(), 0, true).y;
    model.changed(change);
    table.fitRows(presenter.rows() - change.added());
    if (first) {
      // the note of the empty table goes
      table.repaint();
    }
    if (presenter.following()) {
      toBottom();
    } else if (change.removed() > 0) {
      Point at = scroll.getViewport().getViewPosition();
      at.y = Math.max(0, at.y - gone);
      scroll.getViewport().setViewPosition(at);
    }
  }

  /** Does something that may exchange all rows. */
  void keepingSelection(Runnable exchange) {
    int row = selectedRow();
    long position = row < 0 ? -1 : presenter.positionOf(row);
    exchange.run();
    model.fireTableDataChanged();
    table.fitRows(0);
    int now = position < 0 || presenter.rows() == 0 ? -1 : presenter.rowAt(position);
    if (now >= 0 && presenter.positionOf(now) == position) {
      table.getSelectionModel().setSelectionInterval(now, now);
      table.scrollRectToVisible(table.getCellRect(now, 0, true));
    } else if (presenter.following()) {
      toBottom();
    }
    selected.run();
  }

  /** Shows other columns, as people now want them. */
  void columnsChanged() {
    table.fitColumns();
    table.fitRows(0);
    table.revalidate();
    table.repaint();
  }

  /** Opens {@code menu} for a right click, and for the key that stands for one. */
  void setMenu(JPopupMenu menu) {
    table.setComponentPopupMenu(menu);
  }

  /** Keeps the newest in sight from now on, or no longer. */
  void follow(boolean wanted) {
    presenter.follow(wanted);
    if (wanted) {
      toBottom();
    }
    showUnread();
  }

  void jumpToNewest() {
    presenter.follow(true);
    toBottom();
    showUnread();
  }

  void showUnread() {
    chip.show(presenter.following(), presenter.unread());
  }

  private void stayAtBottom() {
    if (presenter.following()) {
      toBottom();
    }
  }

  private void toBottom() {
    int rows = table.getRowCount();
    if (rows > 0) {
      Rectangle cell = table.getCellRect(rows - 1, 0, true);
      cell.x = scroll.getViewport().getViewPosition().x;
      table.scrollRectToVisible(cell);
    }
  }

  /** Who scrolls up wants to read; who scrolls down to the end wants to follow again. */
  private void scrolled() {
    BoundedRangeModel bar = scroll.getVerticalScrollBar().getModel();
    boolean atBottom =
        bar.getValue() + bar.getExtent() >= bar.getMaximum() - table.getRowHeight() / 2;
    if (atBottom) {
      presenter.follow(true);
    } else if (bar.getValue() < lastValue && bar.getMaximum() >= lastMaximum) {
      presenter.follow(false);
    }
    lastValue = bar.getValue();
    lastMaximum = bar.getMaximum();
    showUnread();
  }

  /** Shows where the selected message comes from. */
  void showSelectedSource() {
    int row = selectedRow();
    if (row >= 0) {
      showSource.accept(presenter.row(row));
    }
  }

  private final class Resizing extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent event) {
      stayAtBottom();
    }
  }

  private final class Clicking extends MouseAdapter {
    @Override
    public void mousePressed(MouseEvent event) {
      int row = table.rowAtPoint(event.getPoint());
      if (event.isPopupTrigger() && row >= 0 && !table.isRowSelected(row)) {
        table.getSelectionModel().setSelectionInterval(row, row);
      }
      if (row >= 0 && presenter.following()) {
        followFrom(row);
        showUnread();
      }
    }

    @Override
    public void mouseClicked(MouseEvent event) {
      int row = table.rowAtPoint(event.getPoint());
      if (row >= 0 && (event.getClickCount() == 2 || onLink(event))) {
        showSource.accept(presenter.row(row));
      }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
      table.setCursor(
          Cursor.getPredefinedCursor(onLink(event) ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
    }

    private boolean onLink(MouseEvent event) {
      int row = table.rowAtPoint(event.getPoint());
      int column = table.columnAtPoint(event.getPoint());
      return row >= 0
          && column >= 0
          && LogColumn.at(table.convertColumnIndexToModel(column)) == LogColumn.LINE
          && presenter.row(row).sourceLine().isPresent();
    }
  }

  /** The chip above the lower edge of the table. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Floating extends JPanel {
    private final JComponent below;
    private final JComponent above;

    Floating(JComponent below, JComponent above) {
      super(new BorderLayout());
      this.below = below;
      this.above = above;
      add(above, BorderLayout.SOUTH);
      add(below, BorderLayout.CENTER);
    }

    @Override
    public boolean isOptimizedDrawingEnabled() {
      return false;
    }

    @Override
    public void doLayout() {
      below.setBounds(0, 0, getWidth(), getHeight());
      int width = above.getPreferredSize().width;
      int height = above.getPreferredSize().height;
      above.setBounds((getWidth() - width) / 2, getHeight() - height - 16, width, height);
    }
  }
}
