package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.Locale;
import org.pendant.kit.icon.SvgIcon;

/** Tool of the tree: the buttons above it, in their order. */
enum TreeTool {
  UNDO("undo", text("undo")),
  REDO("redo", text("doAgain")),
  UP("move-up", text("moveUp")),
  DOWN("move-down", text("moveDown")),
  CUT("cut", text("cut")),
  COPY("copy", text("copy")),
  PASTE("paste", text("paste")),
  DELETE("delete", text("delete")),
  SUPPRESS("suppress", text("suppressOrUseAgain")),
  FOLLOW("follow", text("follow"));

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
