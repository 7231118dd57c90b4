package org.pendant.editors.dap;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.recording.Moment;

/**
 * Written lines: the newest log lines of a run, and the moments at which they were written. The
 * thread that drives the robot adds to them, any may read.
 */
final class WrittenLines {
  /** Older ones are forgotten. */
  private static final int MAX_LINES = 1000;

  private static final int MAX_TEXT = 200;

  private final Deque<Written> lines = new ArrayDeque<>();

  /**
   * A line of the log.
   *
   * @param id names it, from 1
   * @param moment the frame, or the stop, that told of it
   * @param line of the program that wrote it, from 1; 0 for none
   * @param text of it, shortened
   */
  record Written(int id, Moment moment, double timeS, int line, String text) {}

  /** Adds what a snapshot has that is new, of log lines after number {@code after}. */
  synchronized void add(ControllerState state, long after) {
    for (LogEntry entry : state.newEntries()) {
      if (entry.number() > after && entry.origin() != LogEntry.Origin.ENDING) {
        lines.add(
            new Written(
                (int) entry.number(),
                Moment.of(state),
                state.timeS(),
                entry.place().map(place -> place.line()).orElse(0),
                ByteText.decoded(LogEntry.shortened(entry.text(), MAX_TEXT))));
      }
    }
    while (lines.size() > MAX_LINES) {
      lines.removeFirst();
    }
  }

  /** All that are known, the oldest first. */
  synchronized List<Written> all() {
    return List.copyOf(lines);
  }

  /** One of them. */
  Optional<Written> of(int id) {
    return all().stream().filter(each -> each.id() == id).findFirst();
  }
}
