package org.pendant.desktop.editor;

import org.fife.ui.rsyntaxtextarea.folding.Fold;
import org.fife.ui.rsyntaxtextarea.folding.FoldManager;

/** Folds: folds and unfolds blocks. */
final class Folds {
  private Folds() {}

  /** The block that begins at the caret's line, or else the one around it. */
  static void toggle(ProgramEditor editor) {
    ScriptArea area = editor.area();
    FoldManager folds = area.getFoldManager();
    Fold fold = folds.getFoldForLine(area.getCaretLineNumber());
    if (fold == null) {
      fold = folds.getDeepestOpenFoldContaining(area.getCaretPosition());
    }
    if (fold != null) {
      if (!fold.isCollapsed()) {
        area.setCaretPosition(area.line(fold.getStartLine() + 1).end());
      }
      fold.toggleCollapsedState();
    }
  }

  static void all(ProgramEditor editor, boolean folded) {
    FoldManager folds = editor.area().getFoldManager();
    for (int i = 0; i < folds.getFoldCount(); i++) {
      set(folds.getFold(i), folded);
    }
  }

  private static void set(Fold fold, boolean folded) {
    for (int i = 0; i < fold.getChildCount(); i++) {
      set(fold.getChild(i), folded);
    }
    fold.setCollapsed(folded);
  }
}
