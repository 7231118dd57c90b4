package org.pendant.gui.log;

import java.util.EnumSet;
import java.util.Set;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;

/**
 * Which messages are shown.
 *
 * @param levels severities
 * @param origins who wrote them
 */
record LogFilter(Set<Level> levels, Set<Origin> origins) {
  /** Every message. */
  static final LogFilter ALL =
      new LogFilter(EnumSet.allOf(Level.class), EnumSet.allOf(Origin.class));

  /** Copies the sets. */
  LogFilter {
    levels = Set.copyOf(levels);
    origins = Set.copyOf(origins);
  }

  boolean accepts(LogLine line) {
    return levels.contains(line.level()) && origins.contains(line.origin());
  }
}
