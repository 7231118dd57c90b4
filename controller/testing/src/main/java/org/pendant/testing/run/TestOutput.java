package org.pendant.testing.run;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.controller.message.Popup;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;

/** Test output: the last lines of the log of a run, for its report. */
final class TestOutput {
  /** Lines that are kept. */
  static final int MAX_LINES = 200;

  /** Bytes of a line that are kept. */
  static final int MAX_BYTES = 1000;

  private final Deque<String> lines = new ArrayDeque<>();

  /** Takes what a frame has brought. */
  void take(ControllerState state) {
    for (LogEntry each : state.newEntries()) {
      if (each.origin() != Origin.ENDING) {
        add(each.timeS(), said(each));
      }
    }
    for (Popup each : state.newPopups()) {
      add(each.timeS(), "popup: " + each.title() + ": " + each.text());
    }
  }

  private static String said(LogEntry entry) {
    return entry.origin() == Origin.SCRIPT
        ? entry.text()
        : entry.level().name().toLowerCase(Locale.ROOT) + ": " + entry.text();
  }

  /** Adds a line; bytes, one {@code char} a byte. */
  void add(double timeS, String text) {
    if (lines.size() == MAX_LINES) {
      lines.removeFirst();
    }
    lines.add(
        String.format(Locale.ROOT, "%9.3f  ", timeS)
            + ByteText.decoded(LogEntry.shortened(text, MAX_BYTES)));
  }

  /** The lines, oldest first. */
  List<String> lines() {
    return List.copyOf(lines);
  }
}
