package org.pendant.kit.layout;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/**
 * Settled texts: lays out a container with texts that wrap. How high these are is known only with
 * their width; here they are laid out again until that fits, before anything is painted: nothing is
 * seen at a wrong place for a moment, or jumps under the pointer.
 */
final class SettledTexts {
  /** A bar that comes or goes changes the width once more. */
  private static final int MAX_TIMES = 4;

  private SettledTexts() {}

  /**
   * Lays out until texts fit.
   *
   * @param in what the texts are in
   * @param layOut lays out all that is not valid
   */
  static void settle(Container in, Runnable layOut) {
    layOut.run();
    for (int i = 1; i < MAX_TIMES; i++) {
      List<JTextArea> wrong = new ArrayList<>();
      find(in, wrong);
      if (wrong.isEmpty()) {
        return;
      }
      wrong.forEach(Component::invalidate);
      layOut.run();
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
