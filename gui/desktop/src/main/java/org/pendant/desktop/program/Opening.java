package org.pendant.desktop.program;

import javax.swing.event.PopupMenuEvent;
import javax.swing.event.PopupMenuListener;

/** Opening listener: fills a popup menu each time it opens. */
record Opening(Runnable fill) implements PopupMenuListener {
  @Override
  public void popupMenuWillBecomeVisible(PopupMenuEvent event) {
    fill.run();
  }

  @Override
  public void popupMenuWillBecomeInvisible(PopupMenuEvent event) {
    // nothing to take back
  }

  @Override
  public void popupMenuCanceled(PopupMenuEvent event) {
    // nothing to take back
  }
}
