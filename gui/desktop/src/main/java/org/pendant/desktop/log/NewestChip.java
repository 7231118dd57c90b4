package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import javax.swing.JButton;

/**
 * Newest message chip: a button that floats above the messages while the newest is not followed.
 */
@SuppressWarnings("serial") // never written to a stream
final class NewestChip extends JButton {

  NewestChip(Runnable jump) {
    setName("log-jump-to-newest");
    putClientProperty("JButton.buttonType", "roundRect");
    setToolTipText(text("showTheNewestMessageAndFollow"));
    getAccessibleContext().setAccessibleName(text("jumpToNewestMessage"));
    addActionListener(event -> jump.run());
    setVisible(false);
  }

  void show(boolean following, int unread) {
    String text = unread == 0 ? text("jumpToNewest") : text("newer", unread);
    if (!following && !text.equals(getText())) {
      setText(text);
      revalidate();
    }
    if (isVisible() == following) {
      setVisible(!following);
    }
  }
}
