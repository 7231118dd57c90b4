package org.pendant.desktop.plot;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.util.Map;

/** Text painting as the desktop wants it. */
public final class TextPainting {
  private TextPainting() {}

  /** Has a pen write smooth letters. */
  public static void smooth(Graphics2D pen) {
    Object hints = Toolkit.getDefaultToolkit().getDesktopProperty("awt.font.desktophints");
    if (hints instanceof Map<?, ?> wanted) {
      pen.addRenderingHints(wanted);
    } else {
      pen.setRenderingHint(
          RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }
  }
}
