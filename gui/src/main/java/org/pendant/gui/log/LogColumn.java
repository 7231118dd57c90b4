package org.pendant.gui.log;

import java.util.List;
import java.util.Locale;

/** The columns of the table of messages. */
enum LogColumn {
  TIME("Time", "000000.000"),
  SEVERITY("Severity", "Warning mm"),
  SOURCE("Source", "Program end"),
  LINE("Line", "00000"),
  MESSAGE("Message", "");

  private static final List<LogColumn> ALL = List.of(values());

  private final String title;
  private final String widest;

  LogColumn(String title, String widest) {
    this.title = title;
    this.widest = widest;
  }

  /** The column at a place, counted from 0. */
  static LogColumn at(int index) {
    return ALL.get(index);
  }

  /** How many there are. */
  static int count() {
    return ALL.size();
  }

  String title() {
    return title;
  }

  /** A text that needs as much room as any; empty for all that is left. */
  String widest() {
    return widest;
  }

  /** What stands in the cell. */
  String text(LogLine line) {
    return switch (this) {
      case TIME -> String.format(Locale.ROOT, "%.3f", line.timeS());
      case SEVERITY -> line.severity();
      case SOURCE -> line.source();
      case LINE ->
          line.sourceLine().isPresent() ? Integer.toString(line.sourceLine().getAsInt()) : "";
      case MESSAGE -> line.firstLine();
    };
  }
}
