package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.script.function.ScriptPlace;

final class LogLineTest {
  private static final Instant WALL = Instant.parse("2026-01-02T03:04:05Z");

  private static LogLine line(
      Origin origin, String code, String text, Optional<ScriptPlace> place) {
    LogEntry entry = new LogEntry(1, 12.3456, Level.ERROR, origin, code, text, place);
    return LogLine.of(1, WALL, LogSource.of(origin), entry);
  }

  private static LogLine said(String text) {
    return line(Origin.SCRIPT, "", text, Optional.empty());
  }

  private static Optional<ScriptPlace> at(String source, int thread) {
    return Optional.of(new ScriptPlace(source, thread, "watch", 12));
  }

  @Test
  void aPlaceLeadsToItsLine() {
    LogLine ended = line(Origin.ENDING, "", "over", at("p.script", 0));
    assertEquals(OptionalInt.of(12), ended.sourceLine());
    assertEquals("main", ended.thread());
    assertEquals("watch", line(Origin.SCRIPT, "", "a", at("p.script", 3)).thread());
  }

  @Test
  void withoutPlaceThereIsNoLine() {
    assertEquals(OptionalInt.empty(), said("line 12 of the order").sourceLine());
    assertEquals("", said("a").lineText());
  }

  @Test
  void linesOfInterpreterModeLeadNowhere() {
    LogLine line = line(Origin.SCRIPT, "", "a", at("interpreter", 0));
    assertEquals(OptionalInt.empty(), line.sourceLine());
    assertEquals("12", line.lineText());
  }

  @Test
  void theTableShowsThatThereIsMoreThanTheFirstLine() {
    assertEquals("one \u2026", said("one\ntwo\n").firstLine());
    assertEquals("one", said("one\n").firstLine());
  }

  @Test
  void aCodeBesideTheMessageIsNotRepeatedInIt() {
    LogLine stop = line(Origin.SAFETY, "C153A2", "C153A2 protective stop at 1 s", Optional.empty());
    assertEquals("protective stop at 1 s", stop.withoutCode());
    assertEquals("over", line(Origin.ENDING, "wrong-type", "over", Optional.empty()).withoutCode());
  }

  @Test
  void stopsReadInTheUnitsThatPeopleHaveChosenAsTheirCardDoes() {
    String hit = "protective stop at 1.344 s: the forearm has hit \"2 m\": 0.00007 m, limit 0 m";
    LogLine stop = line(Origin.SAFETY, "C157A2", hit, Optional.empty());
    assertEquals(
        "protective stop at 1.344 s: the forearm has hit \"2 m\": 0.07 mm, limit 0.00 mm",
        stop.in(PoseForm.STANDARD).text());
    assertEquals("went 0.2 m", said("went 0.2 m").in(PoseForm.STANDARD).text());
  }

  @Test
  void bytesBecomeCharacters() {
    assertEquals("\u00e4", said("\u00c3\u00a4").text());
  }

  @Test
  void csvQuotesWhatWouldBreakIt() {
    assertEquals(
        "12.346,2026-01-02T03:04:05Z,Error,Program,,watch,12,\"say \"\"a, b\"\"\"\n",
        LogExport.CSV.row(
            row(line(Origin.SCRIPT, "", "say \"a, b\"", at("p.script", 3)), "node 4")));
  }

  private static LogExport.Row row(LogLine line, String place) {
    return new LogExport.Row(line, place);
  }

  @Test
  void textSaysWhereAMessageComesFromAsTheTableDoes() {
    LogLine line = line(Origin.SCRIPT, "", "a", at("p.script", 3));
    String row = LogExport.TEXT.row(row(line, "node 4"));
    assertTrue(row.contains("  watch:node 4  "), row);
  }

  @Test
  void furtherLinesOfATextAreIndented() {
    String row = LogExport.TEXT.row(row(said("one\ntwo"), ""));
    String[] lines = row.split("\n", -1);
    assertEquals(lines[0].indexOf("one"), lines[1].indexOf("two"));
    assertEquals("two", lines[1].strip());
  }

  @Test
  void savedMessagesCannotActOnATerminal() {
    LogLine line = said("\u001b]0;owned\u0007");
    for (LogExport form : LogExport.values()) {
      String row = form.row(row(line, ""));
      assertTrue(row.contains("\\x1b]0;owned\\x07"), row);
      assertEquals(1, row.chars().filter(Character::isISOControl).count(), "its line end");
    }
  }
}
