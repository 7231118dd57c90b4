package org.pendant.desktop.workbench;

import org.pendant.controller.state.ControllerState;
import org.pendant.kit.dock.Dockable;

/** View: a part of the window: a screen or a panel. Only the dispatch thread calls it. */
public interface View extends Dockable {

  /**
   * Shows the newest snapshot: about 30 times a second while the view is visible, and once when it
   * becomes visible.
   */
  default void refresh(ControllerState state) {}
}
