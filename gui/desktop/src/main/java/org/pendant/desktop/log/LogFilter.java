package org.pendant.desktop.log;

import java.util.EnumSet;
import java.util.Set;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Log filter: which messages are shown.
 *
 * @param levels severities
 * @param sources who they are from
 */
record LogFilter(Set<Level> levels, Set<LogSource> sources) {
  /** Every message. */
  static final LogFilter ALL =
      new LogFilter(EnumSet.allOf(Level.class), EnumSet.allOf(LogSource.class));

  /** Copies the sets. */
  LogFilter {
    levels = Set.copyOf(levels);
    sources = Set.copyOf(sources);
  }

  boolean accepts(LogLine line) {
    return levels.contains(line.level()) && sources.contains(line.source());
  }
}
