package org.pendant.gui.workbench;

import javax.swing.JComponent;
import org.pendant.controller.state.ControllerState;

/** A part of the window: a screen or a panel. Only the dispatch thread calls it. */
public interface View {

  /** Stable name in settings and commands, such as {@code log}. */
  String id();

  /** What people read on its tab. */
  String title();

  /** What is shown; the same component always. */
  JComponent component();

  /**
   * Shows the newest snapshot: about 30 times a second while the view is visible, and once when it
   * becomes visible.
   */
  default void refresh(ControllerState state) {}
}
