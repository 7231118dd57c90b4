package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.ComponentOrientation;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import org.pendant.desktop.cell.WireLayer.Loose;
import org.pendant.desktop.cell.WireLayer.Wire;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/**
 * Wiring board: signals at the left, devices at the right, wires between them, and the mouse that
 * draws one. Each side scrolls by itself; a wire whose end is out of sight goes to the edge there.
 */
@SuppressWarnings("serial") // never written to a stream
final class WiringBoard extends JPanel {
  private static final int MIN_SIDE = 150;
  private static final int MAX_SIDE = 330;
  private static final double SIDE_SHARE = 0.38;

  /** A press that goes no farther is a click. */
  private static final int CLICK_PX = 4;

  private final WireList signals = new WireList(true);
  private final WireList ports = new WireList(false);
  private final JScrollPane signalScroll = scroll(signals);
  private final JScrollPane portScroll = scroll(ports);
  private final WireLayer layer = new WireLayer();
  private CellWiring wiring = new CellWiring(List.of());
  private Set<String> high = Set.of();
  private Optional<Drag> drag = Optional.empty();
  private BiConsumer<WirePort, WireSignal> drawn = (port, signal) -> {};

  /** A wire that the mouse draws: from a row to where the pointer is, on the board. */
  private record Drag(WireList list, WireRow from, Point pressed, Point pointer) {
    boolean begun() {
      return pressed.distance(pointer) > CLICK_PX;
    }
  }

  /** An empty board. */
  WiringBoard() {
    super(null);
    setOpaque(false);
    setName("cell-wiring-board");
    TitledCard.named(signals, "cell-wiring-signals", text("signalsOfTheController"));
    TitledCard.named(ports, "cell-wiring-ports", text("portsOfDevices"));
    signals.setToolTipText(null);
    ports.setToolTipText(null);
    // the bar is away from where wires begin
    signalScroll.setComponentOrientation(ComponentOrientation.RIGHT_TO_LEFT);
    add(layer);
    add(signalScroll);
    add(portScroll);
    for (WireList list : List.of(signals, ports)) {
      Mouse mouse = new Mouse(list);
      list.addMouseListener(mouse);
      list.onDragged(mouse::mouseDragged);
      list.addListSelectionListener(event -> selected(list));
    }
    addMouseListener(new Clicks());
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            showWires();
          }
        });
  }

  private JScrollPane scroll(WireList list) {
    JScrollPane scroll = new JScrollPane(list);
    scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.setBorder(BorderFactory.createLineBorder(Palette.line()));
    scroll.getViewport().addChangeListener(event -> showWires());
    return scroll;
  }

  /** Overlapping: the layer of wires lies on both lists. */
  @Override
  public boolean isOptimizedDrawingEnabled() {
    return false;
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(UIScale.scale(600), UIScale.scale(400));
  }

  @Override
  public void doLayout() {
    int side =
        Math.clamp(
            (int) (SIDE_SHARE * getWidth()), UIScale.scale(MIN_SIDE), UIScale.scale(MAX_SIDE));
    layer.setBounds(0, 0, getWidth(), getHeight());
    signalScroll.setBounds(0, 0, side, getHeight());
    portScroll.setBounds(getWidth() - side, 0, side, getHeight());
    showWires();
  }

  WireList signals() {
    return signals;
  }

  WireList ports() {
    return ports;
  }

  /** Hears of wires that people draw. */
  void onDrawn(BiConsumer<WirePort, WireSignal> listener) {
    drawn = listener;
  }

  /** Shows another wiring. */
  void show(CellWiring next, List<WireRow> signalRows, List<WireRow> portRows) {
    wiring = next;
    signals.setRows(signalRows);
    ports.setRows(portRows);
    showLevels(high);
    showWires();
  }

  /** Shows which signals are high. */
  void showLevels(Set<String> highNow) {
    boolean same = high.equals(highNow);
    high = highNow;
    Set<String> wired =
        wiring.ports().stream()
            .map(WirePort::signal)
            .filter(each -> !each.isEmpty())
            .collect(Collectors.toUnmodifiableSet());
    signals.setLevels(high, wired);
    ports.setLevels(high, wired);
    if (!same) {
      showWires();
    }
  }

  /** The port whose wire is chosen; empty for none. */
  Optional<WirePort> chosen() {
    return ports.selected().map(row -> ((WireRow.OfPort) row).port()).flatMap(wiring::now);
  }

  /** What is selected on one side is brought into sight on the other. */
  private void selected(WireList list) {
    if (list == ports && list.isFocusOwner()) {
      chosen()
          .filter(WirePort::wired)
          .ifPresent(port -> signals.select(row -> row.text().equals(port.signal())));
    } else if (list == signals && list.isFocusOwner() && drag.isEmpty()) {
      signals
          .selected()
          .map(row -> wiring.at(row.text()))
          .filter(wired -> !wired.isEmpty() && wired.stream().noneMatch(this::isChosen))
          .ifPresent(wired -> choose(wired.getFirst()));
    }
    showWires();
  }

  private boolean isChosen(WirePort port) {
    return chosen().filter(port::isAt).isPresent();
  }

  private void choose(WirePort port) {
    ports.select(row -> row instanceof WireRow.OfPort(WirePort other) && other.isAt(port));
  }

  private void showWires() {
    List<Wire> wires = new ArrayList<>();
    Optional<WirePort> chosen = chosen();
    for (WirePort port : wiring.ports()) {
      if (port.wired()) {
        Optional<Point> from = signals.pin(row -> row.text().equals(port.signal()));
        Optional<Point> to =
            ports.pin(row -> row instanceof WireRow.OfPort(WirePort other) && other.isAt(port));
        if (from.isPresent() && to.isPresent()) {
          Point left = onBoard(signals, from.get());
          Point right = onBoard(ports, to.get());
          wires.add(
              new Wire(
                  port,
                  within(signalScroll, left),
                  within(portScroll, right),
                  high.contains(port.signal()),
                  chosen.filter(port::isAt).isPresent(),
                  within(signalScroll, left).y != left.y
                      || within(portScroll, right).y != right.y));
        }
      }
    }
    layer.show(wires, drag.filter(Drag::begun).map(this::loose));
  }

  private Point onBoard(WireList list, Point at) {
    return SwingUtilities.convertPoint(list, at, this);
  }

  /** At the edge of what is seen of a list, for what is out of sight. */
  private static Point within(JScrollPane scroll, Point at) {
    Rectangle seen = scroll.getBounds();
    int x = scroll.getX() == 0 ? seen.width : seen.x;
    int bottom = seen.y + Math.max(0, seen.height - 1);
    return new Point(x, Math.clamp(at.y, seen.y, bottom));
  }

  private Loose loose(Drag now) {
    JScrollPane scroll = now.list == signals ? signalScroll : portScroll;
    Point from =
        now.list
            .pin(row -> row.equals(now.from))
            .map(pin -> within(scroll, onBoard(now.list, pin)))
            .orElse(now.pressed);
    Optional<WireRow> over = under(now.pointer);
    String why = over.map(row -> WireRow.refusal(now.from, row)).orElse("");
    String words = why.isEmpty() ? over.flatMap(row -> joined(now.from, row)).orElse("") : why;
    return new Loose(from, now.pointer, !why.isEmpty(), words);
  }

  /** What is said of a wire that can be. */
  private Optional<String> joined(WireRow from, WireRow to) {
    return pair(from, to)
        .map(
            pair -> {
              String also = wiring.alsoSetBy(pair.port, pair.signal.name());
              String wire =
                  text(
                      pair.port.way() == WirePort.Way.WATCHES ? "watchesSignal" : "setsSignal",
                      pair.port.device(),
                      pair.port.title(),
                      pair.signal.name());
              return also.isEmpty() ? wire : text("wireAndOther", wire, also);
            });
  }

  private record Pair(WirePort port, WireSignal signal) {}

  private static Optional<Pair> pair(WireRow from, WireRow to) {
    if (from instanceof WireRow.OfPort(WirePort port) && to instanceof WireRow.OfSignal signal) {
      return Optional.of(new Pair(port, signal.signal()));
    }
    return from instanceof WireRow.OfSignal && to instanceof WireRow.OfPort
        ? pair(to, from)
        : Optional.empty();
  }

  /** The row of either list that is seen at a point of the board. */
  private Optional<WireRow> under(Point point) {
    for (WireList list : List.of(signals, ports)) {
      JViewport viewport = (JViewport) list.getParent();
      Point in = SwingUtilities.convertPoint(this, point, viewport);
      if (viewport.contains(in)) {
        return list.at(SwingUtilities.convertPoint(this, point, list))
            .filter(row -> !(row instanceof WireRow.Heading));
      }
    }
    return Optional.empty();
  }

  /** Has rows stand back to which no wire can go from this one; empty for none. */
  void offerFrom(Optional<WireRow> row) {
    for (WireList list : List.of(signals, ports)) {
      list.setDimmed(
          each ->
              row.isPresent()
                  && !(each instanceof WireRow.Heading)
                  && !each.equals(row.get())
                  && !WireRow.refusal(row.get(), each).isEmpty());
    }
  }

  private void setDrag(Optional<Drag> next) {
    boolean begins = next.filter(Drag::begun).isPresent();
    if (begins != drag.filter(Drag::begun).isPresent()) {
      offerFrom(begins ? next.map(Drag::from) : Optional.empty());
      setCursor(Cursor.getPredefinedCursor(begins ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
    }
    drag = next;
    showWires();
  }

  /** Lets go of a wire that is being drawn; answers whether there was one. */
  boolean letGo() {
    boolean was = drag.isPresent();
    setDrag(Optional.empty());
    return was;
  }

  /** Draws a wire from a row of a list. */
  private final class Mouse extends MouseAdapter {
    private final WireList list;

    Mouse(WireList list) {
      this.list = list;
    }

    @Override
    public void mousePressed(MouseEvent event) {
      if (SwingUtilities.isLeftMouseButton(event)) {
        Point at = onBoard(list, event.getPoint());
        setDrag(
            list.at(event.getPoint())
                .filter(row -> !(row instanceof WireRow.Heading))
                .map(row -> new Drag(list, row, at, at)));
      }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      drag.ifPresent(
          now -> {
            Point at = onBoard(list, event.getPoint());
            setDrag(Optional.of(new Drag(list, now.from, now.pressed, at)));
            scrollAt(at);
          });
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      Optional<Drag> done = drag.filter(Drag::begun);
      Optional<Pair> pair =
          done.flatMap(now -> under(now.pointer).flatMap(to -> pair(now.from, to)));
      setDrag(Optional.empty());
      pair.filter(each -> each.port.refusal(each.signal).isEmpty())
          .ifPresent(
              each -> {
                choose(each.port);
                drawn.accept(each.port, each.signal);
              });
    }
  }

  /** Scrolls a list whose edge the pointer is at. */
  private void scrollAt(Point point) {
    for (WireList list : List.of(signals, ports)) {
      Rectangle seen = list.getVisibleRect();
      Rectangle onBoard = SwingUtilities.convertRectangle(list, seen, this);
      int step = list.getFixedCellHeight();
      if (point.x >= onBoard.x && point.x < onBoard.x + onBoard.width) {
        if (point.y < step) {
          list.scrollRectToVisible(new Rectangle(0, seen.y - step, 1, 1));
        } else if (point.y > getHeight() - step) {
          list.scrollRectToVisible(new Rectangle(0, seen.y + seen.height + step, 1, 1));
        }
      }
    }
  }

  /** Chooses the wire under the pointer. */
  private final class Clicks extends MouseAdapter {
    @Override
    public void mousePressed(MouseEvent event) {
      ports.requestFocusInWindow();
      layer.at(event.getPoint()).ifPresent(wire -> choose(wire.port()));
    }
  }
}
