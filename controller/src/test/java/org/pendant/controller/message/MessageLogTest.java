package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;

final class MessageLogTest {
  private final MessageLog log = new MessageLog();

  @Test
  void entriesAreNumberedAndCarryTheTime() {
    log.setTime(0.5);
    log.script("a");
    log.warning("b");
    assertEquals(
        List.of(
            new LogEntry(1, 0.5, Level.INFO, Origin.SCRIPT, "a"),
            new LogEntry(2, 0.5, Level.WARNING, Origin.CONTROLLER, "b")),
        log.takeNew());
    assertTrue(log.takeNew().isEmpty());
    assertEquals(2, log.newest());
  }

  @Test
  void aSlowReaderGetsWhatIsKept() {
    for (int i = 1; i <= MessageLog.KEPT + 10; i++) {
      log.script("line " + i);
    }
    List<LogEntry> all = log.since(0);
    assertEquals(MessageLog.KEPT, all.size());
    assertEquals(11, all.getFirst().number());
    assertEquals(MessageLog.KEPT + 10, all.getLast().number());
    assertEquals(3, log.since(MessageLog.KEPT + 7).size());
    assertTrue(log.since(MessageLog.KEPT + 10).isEmpty());
  }

  @Test
  void everythingOfOneFrameIsHandedOutHoweverMuch() {
    for (int i = 0; i < 3 * MessageLog.KEPT; i++) {
      log.script("x");
    }
    assertEquals(3 * MessageLog.KEPT, log.takeNew().size());
  }

  @Test
  void warnsOnceAProgram() {
    log.warnOnce("slow");
    log.warnOnce("slow");
    assertEquals(1, log.newest());
    log.programStarted();
    log.warnOnce("slow");
    assertEquals(2, log.newest());
  }

  @Test
  void linesOfProgramsAndErrorsSayWhatTheProgramWasAt() {
    LogEntry.Place place = new LogEntry.Place("p.script", 3, "watch", 12);
    log.placeBy(() -> Optional.of(place));
    log.script("a");
    log.safety(Level.ERROR, "C153A2", "C153A2 protective stop");
    log.safety(Level.INFO, "", "unlocked");
    log.info("b");
    List<LogEntry> all = log.takeNew();
    assertEquals(Optional.of(place), all.get(0).place());
    assertEquals(Optional.of(place), all.get(1).place());
    assertEquals("C153A2", all.get(1).code());
    assertEquals(Origin.SAFETY, all.get(1).origin());
    assertEquals(Optional.empty(), all.get(2).place());
    assertEquals(Optional.empty(), all.get(3).place());
  }
}
