package org.pendant.desktop.program;

import java.util.Locale;
import org.pendant.kit.icon.SvgIcon;

/** Tool of the tree: the buttons above it, in their order. */
enum TreeTool {
  UNDO("undo", "Undo"),
  REDO("redo", "Do again"),
  UP("move-up", "Move up"),
  DOWN("move-down", "Move down"),
  CUT("cut", "Cut"),
  COPY("copy", "Copy"),
  PASTE("paste", "Paste"),
  DELETE("delete", "Delete"),
  SUPPRESS("suppress", "Suppress, or use again"),
  FOLLOW("follow", "Follow");

  private final String action;
  private final String title;

  TreeTool(String action, String title) {
    this.action = action;
    this.title = title;
  }

  /** What it does, as the end of an action's id. */
  String action() {
    return action;
  }

  String title() {
    return title;
  }

  SvgIcon icon() {
    return SvgIcon.of("tool/" + name().toLowerCase(Locale.ROOT), 16);
  }
}
