package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.dock.Dockable;
import org.pendant.kit.text.Messages;

/** Timeline canvas: the tracks over time; the mouse and keys move through it. */
@SuppressWarnings("serial") // never written to a stream
final class TimelineCanvas extends JComponent implements Scrollable {
  /** Frames of 2 ms that make 100 ms. */
  private static final int LONG_STEP = 50;

  private static final double ZOOM = 1.25;

  private final LookBack lookBack;
  private final Supplier<PoseForm> form;
  private final TimelinePainter painter = new TimelinePainter();
  private final Pins pins;
  private Tracks tracks = Tracks.NONE;
  private MomentPlaces places = (timeS, line) -> text("line", line);
  private Supplier<List<ClientMark>> clients = List::of;
  private LongConsumer chosen = number -> {};

  /**
   * A timeline of {@code lookBack}.
   *
   * @param form in which units people read what is written on it
   */
  TimelineCanvas(LookBack lookBack, Supplier<PoseForm> form) {
    this.lookBack = lookBack;
    this.form = form;
    pins = new Pins(lookBack);
    setName("timeline-canvas");
    setFocusable(true);
    putClientProperty(Dockable.TAKES_KEYS, true);
    setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
    ToolTipManager.sharedInstance().registerComponent(this);
    Mouse mouse = new Mouse();
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    key("LEFT", () -> lookBack.step(-1));
    key("RIGHT", () -> lookBack.step(1));
    key("shift LEFT", () -> lookBack.step(-LONG_STEP));
    key("shift RIGHT", () -> lookBack.step(LONG_STEP));
    key("control LEFT", () -> toMark(false));
    key("control RIGHT", () -> toMark(true));
    key("W", () -> toPin(true));
    key("shift W", () -> toPin(false));
    key("HOME", lookBack::first);
    key("END", lookBack::last);
    key("ESCAPE", lookBack::live);
    key("ENTER", () -> lookBack.timeS().ifPresent(this::choose));
    key("PLUS", () -> zoom(1 / ZOOM));
    key("ADD", () -> zoom(1 / ZOOM));
    key("EQUALS", () -> zoom(1 / ZOOM));
    key("MINUS", () -> zoom(ZOOM));
    key("SUBTRACT", () -> zoom(ZOOM));
  }

  private void key(String keys, Runnable run) {
    getInputMap().put(KeyStroke.getKeyStroke(keys), keys);
    getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  /**
   * Marks what clients did.
   *
   * @param marks in the order of time
   * @param wanted shows the message with a number
   */
  void markClients(Supplier<List<ClientMark>> marks, LongConsumer wanted) {
    clients = marks;
    chosen = wanted;
  }

  private List<ClientMark> clientMarks() {
    return lookBack.ofFile() ? List.of() : clients.get();
  }

  /** The mark of a client that is nearest to a time, if one is near. */
  private Optional<ClientMark> clientMark(double timeS) {
    double near = near();
    return clientMarks().stream()
        .filter(each -> Math.abs(each.timeS() - timeS) <= near)
        .min(Comparator.comparingDouble(each -> Math.abs(each.timeS() - timeS)));
  }

  private double near() {
    return 4 * lookBack.range().widthS() / Math.max(1, buckets());
  }

  private void choose(double timeS) {
    clientMark(timeS).ifPresent(mark -> chosen.accept(mark.number()));
  }

  /** To a neighbouring mark, if there is one. */
  void toMark(boolean forward) {
    lookBack.toMark(tracks.marks(), forward);
  }

  /** Calls lines so. */
  void nameLinesBy(MomentPlaces names) {
    places = names;
  }

  /** The worst moments of the last run. */
  Pins pins() {
    return pins;
  }

  /** To the next of the worst moments after, or the last before, the one that is looked at. */
  void toPin(boolean forward) {
    double fromS = lookBack.timeS().orElse(lookBack.recording().lastS());
    pins.next(fromS, forward).ifPresent(pin -> lookBack.jump(pin.timeS()));
  }

  private void zoom(double factor) {
    TimeRange range = lookBack.range();
    lookBack.zoom(factor, lookBack.timeS().orElse(range.toS()));
  }

  void show(Tracks found) {
    tracks = found;
    if (painter.provide(found)) {
      revalidate();
    }
    repaint();
  }

  /** How finely tracks can be shown. */
  int buckets() {
    return painter.plotWidth(getWidth());
  }

  private double timeAt(int x) {
    return lookBack.range().timeS((x - painter.left()) / (double) Math.max(1, buckets()));
  }

  @Override
  public Dimension getPreferredSize() {
    return getMinimumSize();
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(UIScale.scale(120), painter.leastHeight(getFontMetrics(getFont())));
  }

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return new Dimension(UIScale.scale(480), painter.height(getFontMetrics(getFont())));
  }

  @Override
  public int getScrollableUnitIncrement(Rectangle visible, int orientation, int way) {
    return getFontMetrics(getFont()).getHeight();
  }

  @Override
  public int getScrollableBlockIncrement(Rectangle visible, int orientation, int way) {
    return visible.height;
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  /** The rows fill a panel that is high enough, and scroll in others. */
  @Override
  public boolean getScrollableTracksViewportHeight() {
    return getParent().getHeight() >= getMinimumSize().height;
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    double timeS = timeAt(event.getX());
    boolean onMarks = painter.onMarks(event.getY());
    Optional<Pin> pin = onMarks ? pins.at(timeS, near()) : Optional.empty();
    Optional<ClientMark> mark = onMarks ? clientMark(timeS) : Optional.empty();
    return pin.map(each -> Messages.told(LookBack.text(each.timeS()), each.text()))
        .or(
            () ->
                mark.map(each -> text("messageOfClient", LookBack.text(each.timeS()), each.text())))
        .orElseGet(() -> tracks.about(timeS, near(), places, form.get()));
  }

  @Override
  public Point getToolTipLocation(MouseEvent event) {
    return new Point(event.getX() + UIScale.scale(12), event.getY() + UIScale.scale(12));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setFont(getFont());
    painter.paint(
        pen,
        getSize(),
        tracks,
        clientMarks(),
        pins.all(),
        new TimelinePainter.Looking(lookBack, form.get(), isFocusOwner()));
    pen.dispose();
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext =
          new AccessibleJComponent() {
            @Override
            public AccessibleRole getAccessibleRole() {
              return AccessibleRole.SLIDER;
            }

            @Override
            public String getAccessibleName() {
              return lookBack.back() ? lookBack.banner() : text("timelineAtNow");
            }
          };
    }
    return accessibleContext;
  }

  private final class Mouse extends MouseAdapter {
    private int dragX;
    private boolean panning;

    @Override
    public void mousePressed(MouseEvent event) {
      requestFocusInWindow();
      dragX = event.getX();
      panning = !SwingUtilities.isLeftMouseButton(event) || event.isShiftDown();
      if (!panning) {
        double timeS = timeAt(event.getX());
        lookBack.scrub(
            pins.at(timeS, near())
                .filter(pin -> painter.onMarks(event.getY()))
                .map(Pin::timeS)
                .orElse(timeS));
      }
    }

    @Override
    public void mouseClicked(MouseEvent event) {
      double timeS = timeAt(event.getX());
      boolean onMark = painter.onMarks(event.getY()) && pins.at(timeS, near()).isEmpty();
      if (SwingUtilities.isLeftMouseButton(event) && onMark) {
        choose(timeS);
      }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      if (panning) {
        lookBack.pan((dragX - event.getX()) * lookBack.range().widthS() / Math.max(1, buckets()));
        dragX = event.getX();
      } else {
        lookBack.scrub(timeAt(event.getX()));
      }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
      if (event.isShiftDown()) {
        lookBack.pan(event.getPreciseWheelRotation() * lookBack.range().widthS() / 10);
      } else {
        lookBack.zoom(Math.pow(ZOOM, event.getPreciseWheelRotation()), timeAt(event.getX()));
      }
    }
  }
}
