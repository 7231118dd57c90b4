package org.pendant.desktop.log;

import java.util.List;

/** Log columns: the columns of the table of messages. */
enum LogColumn {
  TIME("Time", "000000.000", "Robot time, s"),
  WALL_TIME("Time of day", "00:00:00.000", "When the message arrived here"),
  SEVERITY("Severity", "Warning mm", "How bad it is"),
  SOURCE("Source", "Controller", "Who it is from"),
  CODE("Code", "C153A2 m", "Code of the error"),
  THREAD("Thread", "watchdog m", "Script thread of the program"),
  LINE("Line", "00000", "Line of the program; a click shows it"),
  MESSAGE("Message", "", "The message; errors and warnings are shown whole");

  private static final List<LogColumn> ALL = List.of(values());

  private final String title;
  private final String widest;
  private final String meaning;

  LogColumn(String title, String widest, String meaning) {
    this.title = title;
    this.widest = widest;
    this.meaning = meaning;
  }

  /** The column at a place, counted from 0. */
  static LogColumn at(int index) {
    return ALL.get(index);
  }

  /** Its place among all, counted from 0. */
  int index() {
    return ALL.indexOf(this);
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

  /** What stands in it. */
  String meaning() {
    return meaning;
  }

  /** Whether people may hide it. */
  boolean optional() {
    return this != MESSAGE;
  }

  /** What stands in the cell. */
  String text(LogLine line) {
    return switch (this) {
      case TIME -> line.timeText();
      case WALL_TIME -> line.wallText();
      case SEVERITY -> line.severity();
      case SOURCE -> line.source().title();
      case CODE -> line.shortCode();
      case THREAD -> line.thread();
      case LINE -> line.lineText();
      case MESSAGE -> line.firstLine();
    };
  }
}
