package org.pendant.gui.log;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;

final class LogLineTest {

  private static LogLine line(Origin origin, String text) {
    return LogLine.of(new LogEntry(1, 12.3456, Level.ERROR, origin, text));
  }

  @Test
  void aMessageOfTheControllerLeadsToTheLineItNames() {
    LogLine ended = line(Origin.ENDING, "program main stopped in line 12: index is 7");
    assertEquals(OptionalInt.of(12), ended.sourceLine());
  }

  @Test
  void whatProgramsWriteLeadsNowhere() {
    assertEquals(OptionalInt.empty(), line(Origin.SCRIPT, "line 12 of the order").sourceLine());
  }

  @Test
  void thereIsNoLineZero() {
    assertEquals(OptionalInt.empty(), line(Origin.CONTROLLER, "line 0").sourceLine());
  }

  @Test
  void theTableShowsThatThereIsMoreThanTheFirstLine() {
    assertEquals("one \u2026", line(Origin.SCRIPT, "one\ntwo\n").firstLine());
    assertEquals("one", line(Origin.SCRIPT, "one\n").firstLine());
  }

  @Test
  void bytesBecomeCharacters() {
    assertEquals("\u00e4", line(Origin.SCRIPT, "\u00c3\u00a4").text());
  }

  @Test
  void csvQuotesWhatWouldBreakIt() {
    assertEquals(
        "12.346,Error,Script,\"say \"\"a, b\"\"\"\n",
        LogExport.CSV.row(line(Origin.SCRIPT, "say \"a, b\"")));
  }

  @Test
  void furtherLinesOfATextAreIndented() {
    assertEquals(
        "      12.346  Error    Script       one\n" + " ".repeat(36) + "two\n",
        LogExport.TEXT.row(line(Origin.SCRIPT, "one\ntwo")));
  }
}
