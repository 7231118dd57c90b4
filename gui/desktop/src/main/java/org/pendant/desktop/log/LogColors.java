package org.pendant.desktop.log;

import java.awt.Color;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.kit.theme.Palette;

/** Log colours: those of the log in the current theme. */
final class LogColors {
  private LogColors() {}

  /** Of a severity, readable as text. */
  static Color of(Level level) {
    return switch (level) {
      case INFO -> Palette.accent();
      case WARNING -> Palette.warning();
      case ERROR -> Palette.error();
    };
  }

  /** Of a place to click on. */
  static Color link() {
    return Palette.accent();
  }

  /** Of what is less important. */
  static Color quiet() {
    return Palette.quiet();
  }

  /** Behind what is looked for. */
  static Color mark() {
    return Palette.mark();
  }
}
