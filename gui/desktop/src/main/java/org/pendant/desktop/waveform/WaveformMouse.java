package org.pendant.desktop.waveform;

import static org.pendant.desktop.waveform.WaveformTexts.text;

import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;

/**
 * Waveform mouse: a drag draws a stretch of the other level, or moves the change that it begins at;
 * a click changes the level from there to the next change.
 */
final class WaveformMouse extends MouseAdapter {
  private static final int NONE = -1;
  private static final double ZOOM = 1.25;

  private final WaveformCanvas canvas;
  private WaveRow row = WaveRow.idle("digital_in[0]");
  private int change = NONE;
  private double fromS;
  private boolean pressed;
  private boolean dragged;

  WaveformMouse(WaveformCanvas canvas) {
    this.canvas = canvas;
  }

  @Override
  public void mousePressed(MouseEvent event) {
    canvas.requestFocusInWindow();
    int index = canvas.rowAt(event.getY());
    pressed = index >= 0 && SwingUtilities.isLeftMouseButton(event);
    dragged = false;
    fromS = canvas.snapped(canvas.timeAt(event.getX()));
    if (index >= 0) {
      canvas.select(index);
      row = canvas.sheet().rows().get(index);
      change = row.changeNear(canvas.timeAt(event.getX()), canvas.nearS());
      canvas.setCursor(change == NONE ? fromS : row.changes().get(change).timeS());
    }
    menu(event);
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    if (!pressed) {
      return;
    }
    double timeS = canvas.snapped(canvas.timeAt(event.getX()));
    dragged |= Math.abs(timeS - fromS) > 0;
    if (!dragged) {
      return;
    }
    WaveRow drawn = row;
    if (change != NONE) {
      drawn = row.moved(change, timeS, WaveformPainter.FRAME_S);
    } else if (Math.abs(timeS - fromS) > 0) {
      drawn = row.with(Math.min(fromS, timeS), Math.max(fromS, timeS), canvas.drawn(row, fromS));
    }
    canvas.preview(canvas.sheet().with(canvas.selected(), drawn));
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    if (pressed && dragged) {
      canvas.keepPreview();
    } else if (pressed && change == NONE) {
      canvas.replace(row.with(fromS, canvas.drawn(row, fromS)));
    }
    pressed = false;
    menu(event);
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    int index = canvas.rowAt(event.getY());
    boolean edge =
        index >= 0
            && canvas
                    .sheet()
                    .rows()
                    .get(index)
                    .changeNear(canvas.timeAt(event.getX()), canvas.nearS())
                >= 0;
    canvas.setCursor(
        Cursor.getPredefinedCursor(edge ? Cursor.E_RESIZE_CURSOR : Cursor.CROSSHAIR_CURSOR));
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent event) {
    if (event.isControlDown()) {
      canvas.zoom(Math.pow(ZOOM, -event.getPreciseWheelRotation()), canvas.timeAt(event.getX()));
    } else if (canvas.getParent() != null) {
      canvas
          .getParent()
          .dispatchEvent(SwingUtilities.convertMouseEvent(canvas, event, canvas.getParent()));
    }
  }

  private void menu(MouseEvent event) {
    if (!event.isPopupTrigger() || canvas.rowAt(event.getY()) < 0) {
      return;
    }
    JPopupMenu menu = new JPopupMenu();
    int near = change;
    WaveRow of = row;
    JMenuItem remove = new JMenuItem(text("removeThisChangeDel"));
    remove.setEnabled(near != NONE);
    remove.addActionListener(chosen -> canvas.replace(of.without(near)));
    menu.add(remove);
    JMenuItem all = new JMenuItem(text("removeShiftDel", of.signal()));
    all.addActionListener(chosen -> canvas.removeRow());
    menu.add(all);
    menu.show(canvas, event.getX(), event.getY());
  }
}
