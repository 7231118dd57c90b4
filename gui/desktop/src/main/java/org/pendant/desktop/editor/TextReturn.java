package org.pendant.desktop.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.fife.ui.rsyntaxtextarea.folding.Fold;
import org.fife.ui.rsyntaxtextarea.folding.FoldManager;
import org.pendant.desktop.editor.text.TextSpan;

/**
 * Text return: brings people back to where they were in a text: some of it has to wait until the
 * text, or what is known of it, is there. Lines count from 1.
 */
final class TextReturn {
  private final ScriptArea area;
  private final GutterMarks marks;

  /** Breakpoints of a text that is not there yet. */
  private final SortedSet<Integer> waiting = new TreeSet<>();

  /** Blocks that are to be folded once they are known. */
  private List<Integer> folded = List.of();

  private boolean unseen;

  TextReturn(ScriptArea area, GutterMarks marks) {
    this.area = area;
    this.marks = marks;
  }

  // --- breakpoints

  /** Sets breakpoints where the text has lines for them; later if it comes {@code later}. */
  void bringBreakpoints(SortedSet<Integer> lines, boolean later) {
    if (later) {
      waiting.addAll(lines);
    } else {
      lines.stream().filter(line -> line <= area.getLineCount()).forEach(marks::addBreakpoint);
    }
  }

  /** The text is there; whether breakpoints have waited for it. */
  boolean setBreakpoints() {
    if (waiting.isEmpty()) {
      return false;
    }
    SortedSet<Integer> lines = new TreeSet<>(waiting);
    waiting.clear();
    bringBreakpoints(lines, false);
    return true;
  }

  /** Lines with a breakpoint, also those that wait for the text. */
  SortedSet<Integer> breakpoints() {
    return waiting.isEmpty() ? marks.breakpoints() : new TreeSet<>(waiting);
  }

  // --- caret and folds

  /** Goes to a place that the text had; to the nearest if it is shorter now. */
  void go(TextPlace place) {
    TextSpan line = area.line(place.line());
    area.setCaretPosition(Math.min(line.end(), line.start() + place.column() - 1));
    folded = place.folded();
    unseen = true;
  }

  /** Whether the caret was moved before the text could be seen, since the last call. */
  boolean unseen() {
    boolean before = unseen;
    unseen = false;
    return before;
  }

  /** Folds what was folded, when it is known which blocks there are. */
  void fold() {
    if (folded.isEmpty() || area.analysed().isEmpty()) {
      return;
    }
    FoldManager manager = area.getFoldManager();
    for (int line : folded) {
      Fold fold = line <= area.getLineCount() ? manager.getFoldForLine(line - 1) : null;
      if (fold != null) {
        fold.setCollapsed(true);
      }
    }
    folded = List.of();
  }

  /** Where people are now. */
  TextPlace place() {
    int caret = area.getCaretPosition();
    int line = area.lineAt(caret);
    List<Integer> now = new ArrayList<>(folded);
    FoldManager manager = area.getFoldManager();
    for (int i = 0; i < manager.getFoldCount(); i++) {
      collect(manager.getFold(i), now);
    }
    return new TextPlace(line, caret - area.line(line).start() + 1, now);
  }

  private static void collect(Fold fold, List<Integer> lines) {
    if (fold.isCollapsed()) {
      lines.add(fold.getStartLine() + 1);
    }
    for (int i = 0; i < fold.getChildCount(); i++) {
      collect(fold.getChild(i), lines);
    }
  }
}
