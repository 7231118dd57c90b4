package org.pendant.protocols.teachpendant;

import java.util.List;

/** Interpreter log files (manual 13.8), in the folder for logs. */
public final class InterpreterFiles {
  /** Of the present interpreter mode. */
  public static final String CURRENT = "interpreter.log";

  /** Of the last one that was cleared. */
  public static final String LAST = "interpreter.0.log";

  /** Of those that a program keeps. */
  public static final String SAVED = "interpreter.saved.log";

  static final List<String> NAMES = List.of(CURRENT, LAST, SAVED);

  private InterpreterFiles() {}
}
