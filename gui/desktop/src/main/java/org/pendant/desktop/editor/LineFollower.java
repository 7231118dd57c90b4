package org.pendant.desktop.editor;

import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.fife.ui.rsyntaxtextarea.folding.Fold;
import org.fife.ui.rsyntaxtextarea.folding.FoldManager;

/** Line follower: keeps the line that runs in sight in one text, until people scroll away. */
final class LineFollower {
  private final ScriptArea area;
  private final FollowSwitch following;
  private final JScrollPane scroll;
  private int line;
  private int height;

  LineFollower(ScriptArea area, JScrollPane scroll, FollowSwitch following) {
    this.area = area;
    this.following = following;
    this.scroll = scroll;
    scroll.addMouseWheelListener(event -> scrolled());
    scroll
        .getVerticalScrollBar()
        .addMouseListener(
            new MouseAdapter() {
              @Override
              public void mousePressed(MouseEvent event) {
                scrolled();
              }
            });
    // Keys, jumps and whatever else leads away from the line.
    scroll
        .getVerticalScrollBar()
        .addAdjustmentListener(event -> SwingUtilities.invokeLater(this::moved));
  }

  /** The line where the program is now, from 1; 0 for none. */
  void at(int now) {
    if (now != line) {
      line = now;
      look();
    }
  }

  /** The text is shown, or following is on again. */
  void look() {
    if (following.on()) {
      reveal(line);
    }
  }

  /** Scrolls a line to the middle unless it can be seen; the caret stays. */
  void reveal(int wanted) {
    if (wanted < 1 || wanted > area.getLineCount() || !area.isShowing() || inSight(wanted)) {
      return;
    }
    Rectangle place = place(wanted);
    Rectangle seen = area.getVisibleRect();
    int y = Math.max(0, place.y - (seen.height - place.height) / 2);
    area.scrollRectToVisible(new Rectangle(seen.x, y, 1, seen.height));
  }

  private void scrolled() {
    if (line > 0) {
      following.left();
    }
  }

  private void moved() {
    if (scroll.getViewport().getHeight() != height) {
      // Something beside the text has opened or closed.
      height = scroll.getViewport().getHeight();
      look();
      return;
    }
    boolean there = line > 0 && line <= area.getLineCount() && area.isShowing();
    if (there && !inSight(line)) {
      following.left();
    }
  }

  private boolean inSight(int wanted) {
    Rectangle place = place(wanted);
    Rectangle seen = area.getVisibleRect();
    return seen.y <= place.y && place.y + place.height <= seen.y + seen.height;
  }

  /** Where a line is painted, or the head of the folded block that it is in. */
  private Rectangle place(int wanted) {
    FoldManager folds = area.getFoldManager();
    int shown = wanted;
    if (folds.isLineHidden(wanted - 1)) {
      for (int i = 0; i < folds.getFoldCount(); i++) {
        shown =
            hiding(folds.getFold(i), wanted - 1).map(each -> each.getStartLine() + 1).orElse(shown);
      }
    }
    return area.place(area.line(shown).start());
  }

  private static Optional<Fold> hiding(Fold fold, int index) {
    if (!fold.containsLine(index)) {
      return Optional.empty();
    }
    if (fold.isCollapsed()) {
      return Optional.of(fold);
    }
    Optional<Fold> found = Optional.empty();
    for (int i = 0; i < fold.getChildCount() && found.isEmpty(); i++) {
      found = hiding(fold.getChild(i), index);
    }
    return found;
  }
}
