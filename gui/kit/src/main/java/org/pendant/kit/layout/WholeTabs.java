package org.pendant.kit.layout;

import com.formdev.flatlaf.ui.FlatTabbedPaneUI;
import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.JComponent;

/**
 * Whole tabs: a row of tabs that scrolls, in which a tab is written whole or not at all; the one
 * that is chosen stays in sight when the look changes.
 */
public class WholeTabs extends FlatTabbedPaneUI {
  /** The row begins at its first tab again in another look. */
  @Override
  public void installUI(JComponent pane) {
    super.installUI(pane);
    ensureSelectedTabIsVisibleLater();
  }

  /** Three dots of a tab's title say nothing: one without room is in the list only. */
  @Override
  protected void paintTab(
      Graphics pen, int placement, Rectangle[] places, int index, Rectangle icon, Rectangle title) {
    boolean whole = tabViewport == null || tabViewport.getViewRect().contains(places[index]);
    if (whole || index == tabPane.getSelectedIndex()) {
      super.paintTab(pen, placement, places, index, icon, title);
    }
  }
}
