package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.script.function.ScriptPlace;

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
        log.takeNew().entries());
    assertEquals(LogLines.NONE, log.takeNew());
    assertEquals(2, log.newest());
  }

  @Test
  void aSlowReaderGetsWhatIsKept() {
    for (int i = 1; i <= MessageLog.KEPT + 10; i++) {
      log.script("line " + i);
      log.takeNew();
    }
    List<LogEntry> all = log.since(0);
    assertEquals(MessageLog.KEPT, all.size());
    assertEquals(11, all.getFirst().number());
    assertEquals(MessageLog.KEPT + 10, all.getLast().number());
    assertEquals(3, log.since(MessageLog.KEPT + 7).size());
    assertTrue(log.since(MessageLog.KEPT + 10).isEmpty());
  }

  @Test
  void aFrameHoldsSoManyLinesAndOneThatSaysHowManyMoreThereWere() {
    for (int i = 0; i < MessageLog.MAX_IN_FRAME + 7; i++) {
      log.script("x");
    }
    List<LogEntry> lines = log.takeNew().entries();
    assertEquals(MessageLog.MAX_IN_FRAME + 1, lines.size());
    assertEquals("7 more lines were left out in this frame", lines.getLast().text());
    assertEquals(Level.WARNING, lines.getLast().level());
    log.script("y");
    assertEquals("y", log.takeNew().entries().getFirst().text());
  }

  @Test
  void errorsAreNeverLeftOut() {
    for (int i = 0; i < MessageLog.MAX_IN_FRAME; i++) {
      log.script("x");
    }
    log.error("fire");
    assertEquals("fire", log.takeNew().entries().getLast().text());
  }

  @Test
  void aFrameHoldsSoManyBytes() {
    String megabyte = "x".repeat(1 << 20);
    for (int i = 0; i < 10; i++) {
      log.script(megabyte);
    }
    List<LogEntry> lines = log.takeNew().entries();
    assertEquals(9, lines.size());
    assertEquals("2 more lines were left out in this frame", lines.getLast().text());
  }

  @Test
  void aLongLineIsCutAndSaysHowLongItWas() {
    log.script("x".repeat(MessageLog.MAX_TEXT + 1));
    String text = log.takeNew().entries().getFirst().text();
    assertEquals(MessageLog.MAX_TEXT, text.length());
    assertTrue(text.endsWith("x ... (cut, 4194305 bytes in all)"));
  }

  @Test
  void theLogIsBoundedInBytes() {
    for (int i = 0; i < 100; i++) {
      log.script("x".repeat(1 << 20));
      log.takeNew();
    }
    List<LogEntry> all = log.since(0);
    assertEquals(16, all.size());
    assertEquals(100, all.getLast().number());
  }

  @Test
  void linesOfAFrameAreKeptNoLongerThanByTheLog() {
    log.script("old");
    LogLines frame = log.takeNew();
    assertEquals("old", frame.entries().getFirst().text());
    for (int i = 0; i < MessageLog.KEPT; i++) {
      log.script("line " + i);
      log.takeNew();
    }
    assertEquals(List.of(), frame.entries());
  }

  @Test
  void warningsThatDifferAreGivenAThousandTimesAProgram() {
    for (int i = 0; i < 2000; i++) {
      log.warnOnce("slow " + i);
    }
    assertEquals(1000, log.newest());
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
    ScriptPlace place = new ScriptPlace("p.script", 3, "watch", 12);
    log.placeBy(() -> Optional.of(place));
    log.script("a");
    log.safety(Level.ERROR, "C153A2", "C153A2 protective stop");
    log.safety(Level.INFO, "", "unlocked");
    log.info("b");
    List<LogEntry> all = log.takeNew().entries();
    assertEquals(Optional.of(place), all.get(0).place());
    assertEquals(Optional.of(place), all.get(1).place());
    assertEquals("C153A2", all.get(1).code());
    assertEquals(Origin.SAFETY, all.get(1).origin());
    assertEquals(Optional.empty(), all.get(2).place());
    assertEquals(Optional.empty(), all.get(3).place());
  }
}
