package org.pendant.gui.log;

import java.awt.Color;
import javax.swing.JLabel;

/** A label that is less important than what is around it, in every theme. */
@SuppressWarnings("serial") // never written to a stream
final class QuietLabel extends JLabel {
  @Override
  public Color getForeground() {
    return LogColors.quiet();
  }
}
