package org.pendant.kit.layout;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/**
 * Scroll pane around texts that wrap. How high these are is known only with their width; here they
 * are laid out again until that fits, before anything is painted: nothing is seen at a wrong place
 * for a moment, or jumps under the pointer.
 */
@SuppressWarnings("serial") // never written to a stream
public final class SettledScroll extends JScrollPane {
  /** A bar that comes or goes changes the width once more. */
  private static final int MAX_TIMES = 4;

  /**
   * A scroll pane.
   *
   * @param view what scrolls in it
   */
  public SettledScroll(Component view) {
    super(view);
  }

  /**
   * A scroll pane.
   *
   * @param view what scrolls in it
   * @param vertical as {@link JScrollPane#setVerticalScrollBarPolicy} has it
   * @param horizontal as {@link JScrollPane#setHorizontalScrollBarPolicy} has it
   */
  public SettledScroll(Component view, int vertical, int horizontal) {
    super(view, vertical, horizontal);
  }

  @Override
  protected void validateTree() {
    super.validateTree();
    for (int i = 1; i < MAX_TIMES; i++) {
      List<JTextArea> wrong = new ArrayList<>();
      find(getViewport(), wrong);
      if (wrong.isEmpty()) {
        return;
      }
      wrong.forEach(Component::invalidate);
      super.validateTree();
    }
  }

  /** Texts that would be higher or lower with the width that they have now. */
  private static void find(Container in, List<JTextArea> wrong) {
    for (Component each : in.getComponents()) {
      // what scrolls by itself may be as high as it likes
      if (!each.isVisible() || each instanceof JScrollPane) {
        continue;
      }
      if (each instanceof JTextArea text) {
        if (text.getLineWrap() && text.getPreferredSize().height != text.getHeight()) {
          wrong.add(text);
        }
      } else if (each instanceof Container inner) {
        find(inner, wrong);
      }
    }
  }
}
