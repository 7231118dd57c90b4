package org.pendant.kit.layout;

import java.awt.Container;
import java.awt.event.MouseWheelEvent;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;

/**
 * Inner scroll: a scroll pane in a sheet that scrolls too: what it cannot scroll the sheet does.
 */
public final class InnerScroll {
  private InnerScroll() {}

  /** Lets the sheet around a pane scroll where the pane cannot. */
  public static JScrollPane of(JScrollPane pane) {
    pane.addMouseWheelListener(event -> passOn(pane, event));
    return pane;
  }

  private static void passOn(JScrollPane pane, MouseWheelEvent event) {
    JScrollBar bar = pane.getVerticalScrollBar();
    boolean more =
        event.getWheelRotation() < 0
            ? bar.getValue() > bar.getMinimum()
            : bar.getValue() + bar.getVisibleAmount() < bar.getMaximum();
    Container around = SwingUtilities.getAncestorOfClass(JScrollPane.class, pane);
    if (!more && around != null) {
      around.dispatchEvent(SwingUtilities.convertMouseEvent(pane, event, around));
    }
  }
}
