package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntConsumer;
import javax.swing.AbstractAction;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.pendant.kit.theme.Palette;

/** A line between a dock and what is beside it: dragged, or moved with the arrow keys. */
@SuppressWarnings("serial") // never written to a stream
final class Divider extends JPanel {
  private static final int KEY_STEP = 16;

  private final boolean upright;

  /**
   * @param moved told how many pixels to the right or down, after scaling
   */
  Divider(Side side, IntConsumer moved) {
    upright = side == Side.LEFT || side == Side.RIGHT;
    setName("dock-divider-" + side.word());
    setToolTipText(text("dragToChangeTheSize"));
    getAccessibleContext().setAccessibleName(text("sizeOfTheDockAt", side.title()));
    setFocusable(true);
    setCursor(
        Cursor.getPredefinedCursor(upright ? Cursor.E_RESIZE_CURSOR : Cursor.N_RESIZE_CURSOR));
    key(upright ? "LEFT" : "UP", -KEY_STEP, moved);
    key(upright ? "RIGHT" : "DOWN", KEY_STEP, moved);
    MouseAdapter drag =
        new MouseAdapter() {
          private int start;

          @Override
          public void mousePressed(MouseEvent event) {
            start = upright ? event.getX() : event.getY();
          }

          @Override
          public void mouseDragged(MouseEvent event) {
            moved.accept((upright ? event.getX() : event.getY()) - start);
          }
        };
    addMouseListener(drag);
    addMouseMotionListener(drag);
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
  }

  private void key(String key, int step, IntConsumer moved) {
    getInputMap().put(KeyStroke.getKeyStroke(key), key);
    getActionMap()
        .put(
            key,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                moved.accept(UIScale.scale(step));
              }
            });
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(isFocusOwner() ? Palette.accent() : Palette.line());
    int line = UIScale.scale(isFocusOwner() ? 2 : 1);
    if (upright) {
      g.fillRect((getWidth() - line) / 2, 0, line, getHeight());
    } else {
      g.fillRect(0, (getHeight() - line) / 2, getWidth(), line);
    }
  }
}
