package org.pendant.desktop.log;

import java.util.List;

/** Log columns: the columns of the table of messages. */
enum LogColumn {
  TIME(LogTexts.text("time"), "000000.000", LogTexts.text("robotTimeS")),
  WALL_TIME(LogTexts.text("timeOfDay"), "00:00:00.000", LogTexts.text("whenTheMessageArrivedHere")),
  SEVERITY(LogTexts.text("severity"), LogTexts.text("warningMm"), LogTexts.text("howBadItIs")),
  SOURCE(LogTexts.text("source"), LogTexts.text("controller"), LogTexts.text("whoItIsFrom")),
  CODE(LogTexts.text("code"), "C153A2 m", LogTexts.text("codeOfTheError")),
  THREAD(
      LogTexts.text("thread"),
      LogTexts.text("watchdogM"),
      LogTexts.text("scriptThreadOfTheProgram")),
  LINE(LogTexts.text("line"), LogTexts.text("node000"), LogTexts.text("placeInTheProgramAClick")),
  MESSAGE(LogTexts.text("message"), "", LogTexts.text("theMessageErrorsAndWarningsAre"));

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
  String text(LogLine line, LogRuns runs) {
    return switch (this) {
      case TIME -> line.timeText();
      case WALL_TIME -> line.wallText();
      case SEVERITY -> line.severity();
      case SOURCE -> line.source().title();
      case CODE -> line.shortCode();
      case THREAD -> line.thread();
      case LINE -> runs.brief(line);
      case MESSAGE -> line.firstLine();
    };
  }
}
