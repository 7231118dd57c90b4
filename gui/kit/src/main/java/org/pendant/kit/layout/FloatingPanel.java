package org.pendant.kit.layout;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.LookAndFeel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.pendant.kit.theme.Palette;

/**
 * Floating panel: something small that floats over the window beside a place: part of the window,
 * so it takes no focus unless asked to and hides nothing else than what lies under it.
 */
public final class FloatingPanel {
  private static final int GAP = 4;

  private final JComponent owner;
  private final JPanel frame = new JPanel(new BorderLayout());

  /** Whose colours it has: a change of the theme does not reach what is not in the window. */
  private LookAndFeel look = UIManager.getLookAndFeel();

  /** One over the window of {@code owner}. */
  public FloatingPanel(JComponent owner, JComponent content) {
    this.owner = owner;
    frame.add(content);
  }

  /** Whether it is shown. */
  public boolean visible() {
    return frame.getParent() != null;
  }

  /**
   * Shows it, or moves it.
   *
   * @param place what it belongs to, in the owner's coordinates; it stays uncovered if it can
   * @param above whether it belongs over the place
   */
  public void show(Rectangle place, boolean above) {
    JRootPane root = SwingUtilities.getRootPane(owner);
    if (root == null) {
      return;
    }
    frame.setBackground(Palette.card());
    frame.setBorder(BorderFactory.createLineBorder(Palette.line()));
    JLayeredPane layers = root.getLayeredPane();
    if (!layers.equals(frame.getParent())) {
      hide();
      takeLook();
      layers.add(frame, JLayeredPane.POPUP_LAYER);
    }
    Dimension size = frame.getPreferredSize();
    int width = Math.min(size.width, layers.getWidth());
    Point corner = SwingUtilities.convertPoint(owner, place.x, place.y, layers);
    int over = corner.y - GAP;
    int under = layers.getHeight() - (corner.y + place.height + GAP);
    boolean goesAbove =
        above ? over >= size.height || over > under : under < size.height && over > under;
    int height = Math.min(size.height, Math.max(0, goesAbove ? over : under));
    int y = goesAbove ? over - height : corner.y + place.height + GAP;
    int x = Math.max(0, Math.min(corner.x, layers.getWidth() - width));
    frame.setBounds(x, y, width, height);
    frame.validate();
    frame.repaint();
  }

  private void takeLook() {
    LookAndFeel now = UIManager.getLookAndFeel();
    if (!now.equals(look)) {
      look = now;
      SwingUtilities.updateComponentTreeUI(frame);
    }
  }

  /** Takes it away. */
  public void hide() {
    if (frame.getParent() instanceof JComponent layers) {
      Rectangle bounds = frame.getBounds();
      layers.remove(frame);
      layers.repaint(bounds);
    }
  }
}
