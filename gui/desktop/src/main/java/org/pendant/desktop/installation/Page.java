package org.pendant.desktop.installation;

import javax.swing.JComponent;
import org.pendant.controller.state.ControllerState;

/** Page of the Installation screen. */
interface Page {

  /** What is shown; the same component always. */
  JComponent component();

  /** Whether its card takes all the height that there is. */
  default boolean fillsHeight() {
    return false;
  }

  /** Shows the installation as it is now. */
  void show();

  /** Shows the newest snapshot, while the page is visible. */
  default void refresh(ControllerState state) {}
}
