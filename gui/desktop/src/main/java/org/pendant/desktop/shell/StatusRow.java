package org.pendant.desktop.shell;

import java.awt.Component;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * Status row: what was told last, and beside it, while people look at the past, where they are. It
 * is as high as either, whether that is there or not: when people begin to look back, nothing above
 * moves under their pointer. Nor does anything in it: what was told begins at the left as ever, and
 * the line between the two stays, whatever they say.
 */
@SuppressWarnings("serial") // never written to a stream
final class StatusRow extends JPanel {
  /**
   * @param past is there while people look at the past
   * @param status what was told last
   */
  StatusRow(JComponent past, JComponent status) {
    super(new MigLayout("insets 0, gap 0, hidemode 3, filly"));
    add(status, "grow, pushx 100, width 180:180:");
    add(past, "grow, pushx 300, width 0:0:");
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    for (Component each : getComponents()) {
      size.height = Math.max(size.height, each.getPreferredSize().height);
    }
    return size;
  }
}
