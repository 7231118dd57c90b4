package org.pendant.desktop.editor;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JToolTip;
import javax.swing.ToolTipManager;

/**
 * Text tip: the tooltip of a text, which goes when the text scrolls: it tells of what was under the
 * pointer then.
 */
final class TextTip extends ComponentAdapter {
  private Optional<JToolTip> newest = Optional.empty();

  /** That of {@code text}, which shows what {@link #shown} has been told of. */
  TextTip(JComponent text) {
    text.addComponentListener(this);
  }

  /** A tooltip is about to be shown. */
  JToolTip shown(JToolTip tip) {
    newest = Optional.of(tip);
    return tip;
  }

  /** A text that scrolls moves in what shows it. */
  @Override
  public void componentMoved(ComponentEvent event) {
    if (newest.filter(JToolTip::isShowing).isPresent()) {
      // the only way to hide one: as when a button is pressed
      ToolTipManager.sharedInstance()
          .mousePressed(
              new MouseEvent(event.getComponent(), MouseEvent.MOUSE_PRESSED, 0, 0, 0, 0, 1, false));
    }
  }
}
