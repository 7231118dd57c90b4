package org.pendant.kit.dock;

import javax.swing.JComponent;

/** Dockable part of the window: a screen or a panel. Only the dispatch thread calls it. */
public interface Dockable {
  /**
   * Property of the part of a view that keys go to at first, where that is not its first text,
   * table, tree or list.
   */
  String TAKES_KEYS = "pendant.takes-keys";

  /** Stable name in settings and commands, such as {@code log}. */
  String id();

  /** What people read on its tab. */
  String title();

  /** What is shown; the same component always. */
  JComponent component();
}
