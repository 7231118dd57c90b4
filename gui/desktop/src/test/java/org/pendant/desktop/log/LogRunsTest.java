package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.script.function.ScriptPlace;

final class LogRunsTest {
  private final LogRuns runs = new LogRuns();
  private final List<String> shown = new ArrayList<>();

  /** A program whose lines are those of nodes, ten for each. */
  private LogPlaces nodes(String name) {
    return (timeS, source, line) ->
        source.equals(name)
            ? Optional.of(
                new LogPlace(
                    "node " + line / 10,
                    "node " + line / 10 + " of " + name,
                    () -> shown.add(name + " " + line / 10)))
            : Optional.empty();
  }

  private static LogLine message(long number, String source, int line, String controller) {
    LogEntry entry =
        new LogEntry(
            number,
            1.5,
            Level.INFO,
            Origin.SCRIPT,
            "",
            "text",
            Optional.of(new ScriptPlace(source, 0, "main", line)));
    return LogLine.of(number, Instant.EPOCH, LogSource.PROGRAM, entry, controller);
  }

  private static LogLine message(long number, String source, int line) {
    return message(number, source, line, "");
  }

  @Test
  void aMessageIsOfTheProgramThatWasStartedLastBeforeItCame() {
    runs.start(0, "", nodes("a"));
    runs.start(5, "", nodes("b"));
    assertEquals("node 2", runs.brief(message(5, "a", 23)));
    assertEquals("node 2 of a", runs.words(message(5, "a", 23)));
    assertEquals("node 2", runs.shortWords(message(5, "a", 23)));
    assertEquals("node 4 of b", runs.words(message(6, "b", 41)));
    runs.of(message(3, "a", 35)).orElseThrow().show().run();
    assertEquals(List.of("a 3"), shown);
  }

  @Test
  void aMessageOfATextThatNobodyKnowsHasItsLine() {
    runs.start(0, "", nodes("a"));
    assertEquals("23", runs.brief(message(1, "stranger", 23)));
    assertEquals("line 23", runs.words(message(1, "stranger", 23)));
    assertEquals("line 23", runs.shortWords(message(1, "stranger", 23)));
    assertEquals(Optional.empty(), runs.of(message(1, "interpreter", 23)));
    assertEquals("line 23", runs.words(message(1, "interpreter", 23)));
  }

  @Test
  void eachControllerOfACellHasItsOwnPrograms() {
    runs.start(0, "left", nodes("a"));
    runs.start(0, "right", nodes("b"));
    assertEquals("node 2 of a", runs.words(message(1, "a", 20, "left")));
    assertEquals("node 2 of b", runs.words(message(2, "b", 20, "right")));
  }

  @Test
  void theLogOfARecordingHasThePlacesOfItsPrograms() {
    runs.start(0, "", nodes("a"));
    runs.setRecorded(Optional.of(nodes("b")));
    assertEquals("node 2 of b", runs.words(message(1, "b", 20)));
    runs.setRecorded(Optional.empty());
    assertEquals("node 2 of a", runs.words(message(1, "a", 20)));
  }

  @Test
  void theOldestStartsAreForgotten() {
    runs.start(0, "", nodes("a"));
    for (int i = 0; i < LogRuns.MAX_RUNS; i++) {
      runs.start(5, "", nodes("b"));
    }
    assertEquals("line 23", runs.words(message(1, "a", 23)));
  }
}
