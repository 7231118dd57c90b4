package org.pendant.desktop.log;

import javax.swing.JButton;

/**
 * Newest message chip: a button that floats above the messages while the newest is not followed.
 */
@SuppressWarnings("serial") // never written to a stream
final class NewestChip extends JButton {

  NewestChip(Runnable jump) {
    setName("log-jump-to-newest");
    putClientProperty("JButton.buttonType", "roundRect");
    setToolTipText("Show the newest message and follow (Ctrl End)");
    getAccessibleContext().setAccessibleName("Jump to newest message");
    addActionListener(event -> jump.run());
    setVisible(false);
  }

  void show(boolean following, int unread) {
    String text = unread == 0 ? "\u2193 Jump to newest" : "\u2193 " + unread + " newer";
    if (!following && !text.equals(getText())) {
      setText(text);
      revalidate();
    }
    if (isVisible() == following) {
      setVisible(!following);
    }
  }
}
