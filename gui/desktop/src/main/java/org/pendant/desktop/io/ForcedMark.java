package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import javax.swing.JLabel;
import org.pendant.kit.icon.SvgIcon;

/**
 * Forced mark: a diamond beside an input that the user forces; the place stays empty while the
 * input is not forced.
 */
final class ForcedMark {
  private static final SvgIcon THERE = SvgIcon.of("signal/forced", 9).lit();
  private static final SvgIcon AWAY = SvgIcon.of("signal/not-forced", 9);

  private ForcedMark() {}

  static SvgIcon of(boolean forced) {
    return forced ? THERE : AWAY;
  }

  /** Shows it beside a name. */
  static void show(JLabel label, boolean forced) {
    SvgIcon mark = of(forced);
    if (!mark.equals(label.getIcon())) {
      label.setIcon(mark);
      label.getAccessibleContext().setAccessibleDescription(forced ? text("forced") : "");
    }
  }
}
