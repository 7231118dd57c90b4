package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.pendant.kit.theme.Palette;

/**
 * Chart panel: the lines of one chart. The wheel zooms, a drag chooses a stretch of time, a drag
 * with Shift or another button moves it, a double click returns to the newest; arrows and plus and
 * minus do the same by keyboard.
 */
@SuppressWarnings("serial") // never written to a stream
final class ChartPanel extends JPanel {
  /** Lower than this a chart says nothing. */
  static final int MIN_HEIGHT = 160;

  private static final double KEY_STEP = 0.05;

  private final PlotPresenter presenter;
  private final Chart chart;
  private final ChartPainter painter;
  private final Runnable changed;
  private Optional<TimeSpan> span = Optional.empty();
  private boolean draggingCursor;
  private boolean wasLive;
  private int lastX;

  ChartPanel(PlotPresenter presenter, Chart chart, Runnable changed) {
    this.presenter = presenter;
    this.chart = chart;
    this.changed = changed;
    painter = new ChartPainter(presenter);
    setName("plot-chart");
    setFocusable(true);
    setToolTipText(text("wheelZoomDragChooseATime"));
    getAccessibleContext().setAccessibleName(text("chartOf", chart.ids()));
    Pointer pointer = new Pointer();
    addMouseListener(pointer);
    addMouseMotionListener(pointer);
    addMouseWheelListener(pointer);
    key(KeyEvent.VK_LEFT, 0, () -> step(-KEY_STEP, 0));
    key(KeyEvent.VK_RIGHT, 0, () -> step(KEY_STEP, 0));
    key(KeyEvent.VK_LEFT, KeyEvent.SHIFT_DOWN_MASK, () -> step(0, -KEY_STEP));
    key(KeyEvent.VK_RIGHT, KeyEvent.SHIFT_DOWN_MASK, () -> step(0, KEY_STEP));
    key(KeyEvent.VK_PLUS, 0, () -> zoom(0.8, 0.5));
    key(KeyEvent.VK_ADD, 0, () -> zoom(0.8, 0.5));
    key(KeyEvent.VK_MINUS, 0, () -> zoom(1.25, 0.5));
    key(KeyEvent.VK_SUBTRACT, 0, () -> zoom(1.25, 0.5));
    key(KeyEvent.VK_SPACE, 0, () -> pause(!presenter.paused()));
    key(KeyEvent.VK_END, 0, () -> pause(false));
  }

  private void key(int code, int modifiers, Runnable run) {
    String name = "plot-" + code + "-" + modifiers;
    getInputMap().put(KeyStroke.getKeyStroke(code, modifiers), name);
    getActionMap()
        .put(
            name,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
                changed.run();
              }
            });
  }

  private void step(double a, double b) {
    if (presenter.cursors().isPresent()) {
      presenter.shiftCursors(a / 5, b / 5);
    } else {
      presenter.setWindow(presenter.window().moved(a + b));
    }
  }

  private void zoom(double factor, double place) {
    presenter.setWindow(presenter.window().zoomed(factor, place));
  }

  private void pause(boolean wanted) {
    presenter.pause(wanted);
  }

  /** Where the lines are. */
  Rectangle area() {
    return area(this, getWidth(), getHeight());
  }

  /** Where the lines are in a chart of this size; all charts have the same left edge. */
  static Rectangle area(JComponent in, int width, int height) {
    int left = in.getFontMetrics(in.getFont()).stringWidth("-00000.00") + 12;
    return new Rectangle(left, 6, Math.max(0, width - left - 16), Math.max(0, height - 14));
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(200, MIN_HEIGHT);
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    Graphics2D pen = (Graphics2D) g.create();
    TextPainting.smooth(pen);
    pen.setFont(getFont());
    Rectangle area = area();
    painter.paint(pen, chart, area);
    span.ifPresent(drawn -> paintSpan(pen, drawn, area));
    if (isFocusOwner()) {
      pen.setColor(Palette.accent());
      pen.drawRect(area.x, area.y, area.width - 1, area.height);
    }
    pen.dispose();
  }

  private void paintSpan(Graphics2D pen, TimeSpan drawn, Rectangle area) {
    Color color = Palette.accent();
    int from = x(Math.min(drawn.fromS(), drawn.toS()), area);
    int to = x(Math.max(drawn.fromS(), drawn.toS()), area);
    pen.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 48));
    pen.fillRect(from, area.y, to - from, area.height);
  }

  private int x(double timeS, Rectangle area) {
    return area.x + (int) Math.round(presenter.window().placeOf(timeS) * area.width);
  }

  private double timeAt(MouseEvent event) {
    return presenter.window().timeAt(place(event));
  }

  private double place(MouseEvent event) {
    Rectangle area = area();
    return Math.clamp((event.getX() - area.x) / (double) Math.max(1, area.width), 0, 1);
  }

  private final class Pointer extends MouseAdapter {
    private static final int NEAR = 8;

    @Override
    public void mousePressed(MouseEvent event) {
      requestFocusInWindow();
      lastX = event.getX();
      draggingCursor = nearCursor(event);
      if (!draggingCursor && SwingUtilities.isLeftMouseButton(event) && !event.isShiftDown()) {
        wasLive = !presenter.paused();
        presenter.pause(true);
        span = Optional.of(new TimeSpan(timeAt(event), timeAt(event)));
      }
    }

    private boolean nearCursor(MouseEvent event) {
      Rectangle area = area();
      return presenter
          .cursors()
          .filter(
              both ->
                  Math.abs(x(both.aS(), area) - event.getX()) < NEAR
                      || Math.abs(x(both.bS(), area) - event.getX()) < NEAR)
          .isPresent();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      if (draggingCursor) {
        presenter.moveCursor(timeAt(event));
      } else if (span.isPresent()) {
        span = Optional.of(new TimeSpan(span.get().fromS(), timeAt(event)));
      } else {
        double share = (lastX - event.getX()) / (double) Math.max(1, area().width);
        presenter.setWindow(presenter.window().moved(share));
        lastX = event.getX();
      }
      changed.run();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      span.ifPresent(this::choose);
      span = Optional.empty();
      changed.run();
    }

    /** A mere click chooses nothing, and charts that moved continue. */
    private void choose(TimeSpan drawn) {
      if (Math.abs(x(drawn.fromS(), area()) - x(drawn.toS(), area())) >= NEAR) {
        presenter.setWindow(presenter.window().between(drawn.fromS(), drawn.toS()));
      } else {
        presenter.pause(!wasLive);
      }
    }

    @Override
    public void mouseClicked(MouseEvent event) {
      if (event.getClickCount() == 2) {
        presenter.pause(false);
        changed.run();
      }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
      zoom(Math.pow(1.15, event.getPreciseWheelRotation()), place(event));
      changed.run();
    }
  }
}
