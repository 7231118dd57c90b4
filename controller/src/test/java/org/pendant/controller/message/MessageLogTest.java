package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
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
}
