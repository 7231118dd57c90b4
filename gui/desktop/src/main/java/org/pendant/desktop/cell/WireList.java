package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.AbstractListModel;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.ToolTipManager;
import javax.swing.UIManager;
import org.pendant.kit.theme.Palette;

/** Wire list: signals or ports, each with a pin at the side where wires begin. */
@SuppressWarnings("serial") // never written to a stream
final class WireList extends JList<WireRow> {
  private static final int PIN = 9;
  private static final int INDENT = 10;

  private final Rows rows = new Rows();
  private final boolean pinsRight;
  private Set<String> high = Set.of();
  private Set<String> wired = Set.of();
  private Predicate<WireRow> dimmed = row -> false;
  private Consumer<MouseEvent> dragged = event -> {};

  /** The row that was selected last. */
  private int before;

  /**
   * Nothing in it yet.
   *
   * @param pinsRight whether pins are at its right
   */
  WireList(boolean pinsRight) {
    this.pinsRight = pinsRight;
    setModel(rows);
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setCellRenderer(new Cell());
    setFixedCellHeight(UIScale.scale(22));
    setBackground(Palette.card());
    ToolTipManager.sharedInstance().registerComponent(this);
    addListSelectionListener(event -> skipHeading());
  }

  /** Hears where the mouse is dragged, which selects nothing. */
  void onDragged(Consumer<MouseEvent> listener) {
    dragged = listener;
  }

  @Override
  protected void processMouseMotionEvent(MouseEvent event) {
    if (event.getID() == MouseEvent.MOUSE_DRAGGED) {
      dragged.accept(event);
    } else {
      super.processMouseMotionEvent(event);
    }
  }

  /** As wide as there is room: what is too long is cut. */
  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  /** Its rows, all at once. */
  private static final class Rows extends AbstractListModel<WireRow> {
    private List<WireRow> all = List.of();

    @Override
    public int getSize() {
      return all.size();
    }

    @Override
    public WireRow getElementAt(int index) {
      return all.get(index);
    }

    void set(List<WireRow> next) {
      List<WireRow> old = all;
      all = List.copyOf(next);
      if (old.size() == all.size()) {
        fireContentsChanged(this, 0, all.size() - 1);
      } else {
        fireIntervalRemoved(this, 0, Math.max(0, old.size() - 1));
        fireIntervalAdded(this, 0, Math.max(0, all.size() - 1));
      }
    }
  }

  /** Shows these rows, with the same one selected where it is still there. */
  void setRows(List<WireRow> next) {
    if (!next.equals(rows.all)) {
      Optional<WireRow> selected = selected();
      rows.set(next);
      selected.ifPresent(row -> select(same -> isSame(row, same)));
    }
  }

  private static boolean isSame(WireRow one, WireRow other) {
    if (one instanceof WireRow.OfPort(WirePort port)) {
      return other instanceof WireRow.OfPort(WirePort same) && port.isAt(same);
    }
    return one.text().equals(other.text());
  }

  /**
   * What is told of signals.
   *
   * @param highNow names of those that are high
   * @param wiredNow names of those that have a wire
   */
  void setLevels(Set<String> highNow, Set<String> wiredNow) {
    if (!high.equals(highNow) || !wired.equals(wiredNow)) {
      high = highNow;
      wired = wiredNow;
      repaint();
    }
  }

  /** Has rows stand back to which no wire can go now. */
  void setDimmed(Predicate<WireRow> rowsThatCannot) {
    dimmed = rowsThatCannot;
    repaint();
  }

  Optional<WireRow> selected() {
    return Optional.ofNullable(getSelectedValue()).filter(row -> !(row instanceof WireRow.Heading));
  }

  /** Selects the first row of a kind, and scrolls to it. */
  void select(Predicate<WireRow> wanted) {
    for (int i = 0; i < rows.getSize(); i++) {
      if (wanted.test(rows.getElementAt(i))) {
        setSelectedIndex(i);
        ensureIndexIsVisible(i);
        return;
      }
    }
  }

  /** The row at a point of the list; empty for none. */
  Optional<WireRow> at(Point point) {
    int index = locationToIndex(point);
    return index >= 0 && getCellBounds(index, index).contains(point)
        ? Optional.of(rows.getElementAt(index))
        : Optional.empty();
  }

  /** The middle of the pin of the first such row, in the list; empty where there is none. */
  Optional<Point> pin(Predicate<WireRow> wanted) {
    for (int i = 0; i < rows.getSize(); i++) {
      if (wanted.test(rows.getElementAt(i))) {
        Rectangle cell = getCellBounds(i, i);
        int x = pinsRight ? cell.x + cell.width : cell.x;
        return Optional.of(new Point(x, cell.y + cell.height / 2));
      }
    }
    return Optional.empty();
  }

  /** Keys go past headings. */
  private void skipHeading() {
    int index = getSelectedIndex();
    if (index >= 0 && rows.getElementAt(index) instanceof WireRow.Heading) {
      int by = index < before ? -1 : 1;
      int next = index;
      while (next >= 0
          && next < rows.getSize()
          && rows.getElementAt(next) instanceof WireRow.Heading) {
        next += by;
      }
      if (next >= 0 && next < rows.getSize()) {
        setSelectedIndex(next);
        ensureIndexIsVisible(next);
      } else {
        ensureIndexIsVisible(index);
        setSelectedIndex(before);
      }
      return;
    }
    before = Math.max(0, index);
  }

  /** All rows of a kind. */
  List<WireRow> rows(Predicate<WireRow> wanted) {
    List<WireRow> found = new ArrayList<>();
    for (WireRow row : rows.all) {
      if (wanted.test(row)) {
        found.add(row);
      }
    }
    return found;
  }

  private boolean isHigh(WireRow row) {
    return switch (row) {
      case WireRow.OfSignal of -> high.contains(of.signal().name());
      case WireRow.OfPort of -> high.contains(of.port().signal());
      case WireRow.Heading heading -> heading.lit();
    };
  }

  private boolean isWired(WireRow row) {
    return switch (row) {
      case WireRow.OfSignal of -> wired.contains(of.signal().name());
      case WireRow.OfPort of -> of.port().wired();
      case WireRow.Heading _ -> false;
    };
  }

  /** A disc where wires begin: full when one does. */
  private final class Pin extends JComponent {
    private WireRow row = new WireRow.Heading("", "", false);

    Pin() {
      setPreferredSize(UIScale.scale(new Dimension(PIN + 6, PIN)));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      boolean heading = row instanceof WireRow.Heading;
      if (heading && !isHigh(row)) {
        return;
      }
      Graphics2D pen = (Graphics2D) graphics.create();
      pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      double size = UIScale.scale((float) PIN) - 1;
      double x = pinsRight ? getWidth() - size - 2 : 1;
      Ellipse2D disc = new Ellipse2D.Double(x, (getHeight() - size) / 2, size, size);
      Color color = isHigh(row) ? Palette.ok() : Palette.quiet();
      pen.setColor(isHigh(row) || isWired(row) ? color : Palette.card());
      pen.fill(disc);
      pen.setColor(dimmed.test(row) && !heading ? Palette.line() : color);
      pen.draw(disc);
      pen.dispose();
    }
  }

  /** A row as it is seen. */
  private final class Cell extends JPanel implements ListCellRenderer<WireRow> {
    private final JLabel text = new JLabel();
    private final JLabel note = new JLabel();
    private final Pin pin = new Pin();

    Cell() {
      super(new BorderLayout(UIScale.scale(8), 0));
      JPanel words = new JPanel(new BorderLayout(UIScale.scale(8), 0));
      words.setOpaque(false);
      words.add(text, BorderLayout.WEST);
      words.add(note, BorderLayout.CENTER);
      note.setHorizontalAlignment(pinsRight ? SwingConstants.LEADING : SwingConstants.TRAILING);
      add(words, BorderLayout.CENTER);
      add(pin, pinsRight ? BorderLayout.EAST : BorderLayout.WEST);
    }

    /** What the row says where there is no room for all of it. */
    @Override
    public String getToolTipText(MouseEvent event) {
      boolean whole =
          text.getPreferredSize().width <= text.getWidth()
              && note.getPreferredSize().width <= note.getWidth();
      return whole ? null : text.getText() + " \u2013 " + note.getText();
    }

    @Override
    public Component getListCellRendererComponent(
        JList<? extends WireRow> list, WireRow row, int index, boolean selected, boolean focused) {
      boolean heading = row instanceof WireRow.Heading;
      boolean marked = selected && !heading;
      setBackground(
          !marked
              ? Palette.card()
              : list.isFocusOwner()
                  ? list.getSelectionBackground()
                  : UIManager.getColor("List.selectionInactiveBackground"));
      int indent = UIScale.scale(heading ? 0 : INDENT);
      setBorder(
          BorderFactory.createEmptyBorder(
              0, pinsRight ? 6 + indent : 0, 0, pinsRight ? 0 : UIScale.scale(6)));
      Font font = list.getFont();
      text.setFont(heading ? font.deriveFont(Font.BOLD) : font);
      note.setFont(font);
      text.setText(heading || pinsRight ? row.text() : "  " + row.text());
      note.setText(row.note());
      Color strong =
          marked && list.isFocusOwner() ? list.getSelectionForeground() : list.getForeground();
      text.setForeground(dimmed.test(row) && !marked ? Palette.quiet() : strong);
      note.setForeground(marked && list.isFocusOwner() ? strong : Palette.quiet());
      pin.row = row;
      getAccessibleContext().setAccessibleName(spoken(row));
      return this;
    }

    private String spoken(WireRow row) {
      String said =
          (row instanceof WireRow.OfPort(WirePort port) ? port.device() + ", " : "")
              + row.text()
              + (row.note().isEmpty() ? "" : ", " + row.note());
      if (row instanceof WireRow.Heading) {
        return said;
      }
      return text(isHigh(row) ? "spokenHigh" : "spokenLow", said);
    }
  }
}
