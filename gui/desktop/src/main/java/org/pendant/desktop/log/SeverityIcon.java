package org.pendant.desktop.log;

import org.pendant.controller.message.LogEntry.Level;
import org.pendant.kit.icon.SvgIcon;

/** Severity icon: a circle, a triangle or an octagon, which differ in shape, not only in colour. */
final class SeverityIcon {
  private static final SvgIcon INFO = SvgIcon.of("severity/info", 16);
  private static final SvgIcon WARNING = SvgIcon.of("severity/warning", 16);
  private static final SvgIcon ERROR = SvgIcon.of("severity/error", 16);

  private SeverityIcon() {}

  static SvgIcon of(Level level) {
    return switch (level) {
      case INFO -> INFO;
      case WARNING -> WARNING;
      case ERROR -> ERROR;
    };
  }
}
