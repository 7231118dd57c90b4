package org.pendant.desktop.waveform;

import static org.pendant.desktop.waveform.WaveformTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.ToolTipManager;
import org.pendant.desktop.unit.TimeStep;
import org.pendant.kit.dock.Dockable;

/** Waveform canvas: the rows over time; the mouse and keys draw in it. */
@SuppressWarnings("serial") // never written to a stream
final class WaveformCanvas extends JComponent {
  private static final int LONG_STEP = 10;
  private static final double ZOOM = 1.25;
  private static final double MAX_PX_PER_S = 5000;
  private static final double MIN_PX_PER_S = 0.2;

  /** Wider pictures no screen needs and Swing does not draw. */
  private static final int MAX_WIDTH = 2_000_000;

  private final transient WaveformDraft draft;
  private final transient Supplier<String> number;
  private final transient WaveformPainter painter;
  private transient Optional<WaveSheet> preview = Optional.empty();
  private transient WaveformCapture capture = WaveformCapture.NONE;
  private transient OptionalDouble playS = OptionalDouble.empty();
  private double pxPerS = 80;
  private int selected;
  private double cursorS;
  private transient Runnable selection = () -> {};

  /**
   * A canvas for a draft.
   *
   * @param number what an input that takes numbers gets where people draw
   */
  WaveformCanvas(WaveformDraft draft, WaveformPainter painter, Supplier<String> number) {
    this.draft = draft;
    this.painter = painter;
    this.number = number;
    setName("waveform-canvas");
    setFocusable(true);
    putClientProperty(Dockable.TAKES_KEYS, true);
    setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
    ToolTipManager.sharedInstance().registerComponent(this);
    WaveformMouse mouse = new WaveformMouse(this);
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            repaint();
          }

          @Override
          public void focusLost(FocusEvent event) {
            repaint();
          }
        });
    keys();
    draft.addListener(this::changed);
  }

  private void keys() {
    key("LEFT", () -> moveCursor(-1));
    key("RIGHT", () -> moveCursor(1));
    key("shift LEFT", () -> moveCursor(-LONG_STEP));
    key("shift RIGHT", () -> moveCursor(LONG_STEP));
    key("control LEFT", () -> moveChange(-1));
    key("control RIGHT", () -> moveChange(1));
    key("UP", () -> select(selected - 1));
    key("DOWN", () -> select(selected + 1));
    key("HOME", () -> setCursor(0));
    key("END", () -> setCursor(draft.sheet().endS()));
    key("SPACE", this::changeAtCursor);
    key("DELETE", this::removeChange);
    key("shift DELETE", this::removeRow);
    key("control Z", draft::undo);
    key("control Y", draft::redo);
    key("control shift Z", draft::redo);
    for (String plus : new String[] {"PLUS", "ADD", "EQUALS"}) {
      key(plus, () -> zoom(ZOOM, cursorS));
    }
    for (String minus : new String[] {"MINUS", "SUBTRACT"}) {
      key(minus, () -> zoom(1 / ZOOM, cursorS));
    }
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

  /** Tells {@code listener} when another row is selected. */
  void onSelection(Runnable listener) {
    selection = listener;
  }

  private void changed() {
    preview = Optional.empty();
    selected = Math.clamp(selected, 0, Math.max(0, draft.sheet().rows().size() - 1));
    revalidate();
    repaint();
    selection.run();
  }

  /** Shows what signals did in the last run. */
  void show(WaveformCapture run) {
    capture = run;
    revalidate();
    repaint();
  }

  WaveformCapture capture() {
    return capture;
  }

  /** Where the program that runs is, s since its start. */
  void showPlace(OptionalDouble timeS) {
    if (!timeS.equals(playS)) {
      playS = timeS;
      repaint();
    }
  }

  /** What is drawn: the draft, or what it would be if the mouse were released now. */
  WaveSheet sheet() {
    return preview.orElseGet(draft::sheet);
  }

  void preview(WaveSheet sheet) {
    preview = Optional.of(sheet);
    repaint();
  }

  /** Makes what the mouse has drawn the draft. */
  void keepPreview() {
    Optional<WaveSheet> drawn = preview;
    preview = Optional.empty();
    drawn.ifPresent(draft::set);
    repaint();
  }

  /** The selected row; empty if there is none. */
  Optional<WaveRow> row() {
    return sheet().rows().isEmpty() ? Optional.empty() : Optional.of(sheet().rows().get(selected));
  }

  int selected() {
    return selected;
  }

  void select(int row) {
    selected = Math.clamp(row, 0, Math.max(0, sheet().rows().size() - 1));
    scrollRectToVisible(new Rectangle(x(cursorS), y(selected), 1, painter.rowHeight(this)));
    repaint();
    selection.run();
  }

  double cursorS() {
    return cursorS;
  }

  void setCursor(double timeS) {
    cursorS = Math.max(0, snapped(timeS));
    scrollRectToVisible(
        new Rectangle(x(cursorS) - UIScale.scale(20), y(selected), UIScale.scale(40), 1));
    repaint();
  }

  private void moveCursor(int steps) {
    setCursor(cursorS + steps * snapS());
  }

  /** What a row becomes where people draw at a time. */
  String drawn(WaveRow row, double timeS) {
    return row.level() ? row.opposite(timeS) : number.get();
  }

  private void changeAtCursor() {
    row().ifPresent(row -> replace(row.with(cursorS, drawn(row, cursorS))));
  }

  private void removeChange() {
    row()
        .ifPresent(
            row -> {
              int index = row.changeNear(cursorS, nearS());
              if (index >= 0) {
                replace(row.without(index));
              }
            });
  }

  private void moveChange(int steps) {
    row()
        .ifPresent(
            row -> {
              int index = row.changeNear(cursorS, nearS());
              if (index >= 0) {
                WaveRow moved =
                    row.moved(index, snapped(cursorS + steps * snapS()), WaveformPainter.FRAME_S);
                double timeS = moved.changes().get(index).timeS();
                replace(moved);
                setCursor(timeS);
              }
            });
  }

  /** Removes the selected row. */
  void removeRow() {
    if (row().isPresent()) {
      draft.set(draft.sheet().without(selected));
    }
  }

  void replace(WaveRow row) {
    draft.set(draft.sheet().with(selected, row));
  }

  /** Shows more or less; {@code timeS} stays where it is. */
  void zoom(double factor, double timeS) {
    Rectangle seen = getVisibleRect();
    int before = x(timeS) - seen.x;
    pxPerS = Math.clamp(pxPerS * factor, MIN_PX_PER_S, MAX_PX_PER_S);
    pxPerS = Math.min(pxPerS, MAX_WIDTH / Math.max(1, lengthS()));
    setSize(Math.max(getPreferredSize().width, seen.width), getHeight());
    revalidate();
    scrollRectToVisible(new Rectangle(x(timeS) - before, seen.y, seen.width, 1));
    repaint();
  }

  private double lengthS() {
    return 1.05 * Math.max(5, Math.max(sheet().endS(), capture.lengthS()));
  }

  int x(double timeS) {
    return (int) Math.round(timeS * UIScale.scale((float) pxPerS));
  }

  double timeAt(int x) {
    return Math.max(0, x / UIScale.scale((float) pxPerS));
  }

  /** How near is near, s. */
  double nearS() {
    return timeAt(UIScale.scale(5));
  }

  /** To what times snap, s: about four pixels, whole frames. */
  private double snapS() {
    return TimeStep.atLeast(timeAt(UIScale.scale(4)));
  }

  double snapped(double timeS) {
    double snap = snapS();
    return Math.rint(Math.rint(timeS / snap) * snap * 1e6) / 1e6;
  }

  int y(int row) {
    return row * painter.rowHeight(this);
  }

  /** The row of an input at a height; -1 for none. */
  int rowAt(int y) {
    int row = y / painter.rowHeight(this);
    return row >= 0 && row < sheet().rows().size() ? row : -1;
  }

  OptionalDouble playS() {
    return playS;
  }

  @Override
  public Dimension getPreferredSize() {
    int rows = sheet().rows().size() + capture.outputs().size();
    return new Dimension(x(lengthS()), rows * painter.rowHeight(this));
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAt(event.getY());
    double timeS = timeAt(event.getX());
    return row < 0 ? null : painter.about(sheet().rows().get(row), timeS);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setFont(getFont());
    painter.paint(pen, this);
    pen.dispose();
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext =
          new AccessibleJComponent() {
            @Override
            public AccessibleRole getAccessibleRole() {
              return AccessibleRole.CANVAS;
            }

            @Override
            public String getAccessibleName() {
              return row()
                  .map(row -> painter.about(row, cursorS))
                  .orElse(text("waveformsOfInputsNoneYet"));
            }
          };
    }
    return accessibleContext;
  }
}
