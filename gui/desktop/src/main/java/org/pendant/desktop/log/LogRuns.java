package org.pendant.desktop.log;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;

/**
 * Log runs: of which program the messages of the log are: of the one that was started last before
 * they came.
 */
final class LogRuns {
  /** So many starts are known, the newest. */
  static final int MAX_RUNS = 50;

  private final Deque<Start> starts = new ArrayDeque<>();
  private Optional<LogPlaces> recorded = Optional.empty();

  /** A program starts on a controller after a message. */
  private record Start(long after, String controller, LogPlaces places) {}

  /**
   * A program starts.
   *
   * @param after number of the newest message by then
   * @param controller the one of a cell that it starts on
   */
  void start(long after, String controller, LogPlaces places) {
    starts.addLast(new Start(after, controller, places));
    if (starts.size() > MAX_RUNS) {
      starts.removeFirst();
    }
  }

  /** The messages are those of a recording, or no longer. */
  void setRecorded(Optional<LogPlaces> places) {
    recorded = places;
  }

  /** Where a message comes from; empty if that is not known. */
  Optional<LogPlace> of(LogLine line) {
    if (line.sourceLine().isEmpty()) {
      return Optional.empty();
    }
    return recorded
        .or(() -> started(line))
        .flatMap(
            places ->
                places.of(
                    line.timeS(),
                    line.place().orElseThrow().source(),
                    line.sourceLine().getAsInt()));
  }

  private Optional<LogPlaces> started(LogLine line) {
    for (Iterator<Start> each = starts.descendingIterator(); each.hasNext(); ) {
      Start start = each.next();
      if (start.after() < line.number() && start.controller().equals(line.controller())) {
        return Optional.of(start.places());
      }
    }
    return Optional.empty();
  }

  /** What stands in a narrow column; empty for no place. */
  String brief(LogLine line) {
    return of(line).map(LogPlace::brief).orElse(line.lineText());
  }

  /** As {@link #words} where there is little room. */
  String shortWords(LogLine line) {
    String brief = brief(line);
    return brief.equals(line.lineText()) ? LogTexts.text("inLine", brief) : brief;
  }

  /** What the place is called in a sentence; empty for none. */
  String words(LogLine line) {
    return of(line)
        .map(LogPlace::words)
        .orElseGet(() -> line.lineText().isEmpty() ? "" : LogTexts.text("inLine", line.lineText()));
  }
}
