package org.pendant.controller.message;

import java.util.List;

/** Log lines that follow each other, such as those of a frame. Any thread may read them. */
public sealed interface LogLines {
  /** No lines. */
  LogLines NONE = new Listed(List.of());

  /** Those that can still be had, oldest first. */
  List<LogEntry> entries();

  /** Lines that are kept for themselves. */
  record Listed(List<LogEntry> entries) implements LogLines {
    /** Copies the list. */
    public Listed {
      entries = List.copyOf(entries);
    }
  }

  /**
   * Lines that are kept as long as the log keeps them, so that many snapshots hold a line once.
   *
   * @param after number of the line before the first
   * @param last number of the last line
   */
  record InLog(MessageLog log, long after, long last) implements LogLines {
    @Override
    public List<LogEntry> entries() {
      return log.between(after, last);
    }
  }
}
