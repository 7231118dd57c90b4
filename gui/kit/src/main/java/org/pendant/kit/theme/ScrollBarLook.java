package org.pendant.kit.theme;

import com.formdev.flatlaf.ui.FlatScrollBarUI;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;

/**
 * Look of scroll bars, whose tracks are drawn without smoothing. A smooth rectangle is sent to X in
 * tiles of 32x32 pixels, and a track is drawn again with each key that is typed beside it.
 */
public final class ScrollBarLook extends FlatScrollBarUI {
  /** The look of {@code bar}; Swing calls it by its name. */
  public static ComponentUI createUI(JComponent bar) {
    return new ScrollBarLook();
  }

  @Override
  protected void paintTrack(Graphics g, JComponent bar, Rectangle track) {
    // a track with round ends needs it
    if (trackArc > 0 || !(g instanceof Graphics2D pen)) {
      super.paintTrack(g, bar, track);
      return;
    }
    Object smooth = pen.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    super.paintTrack(pen, bar, track);
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, smooth);
  }
}
