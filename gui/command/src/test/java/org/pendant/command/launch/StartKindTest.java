package org.pendant.command.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class StartKindTest {

  private static StartKind kind(boolean display, String... words) {
    return StartKind.of(List.of(words), display, "pick.script"::equals);
  }

  @ParameterizedTest
  @CsvSource({
    "COMMAND, run pick.script",
    "COMMAND, --version",
    "COMMAND, open --help",
    "COMMAND, missing.script",
    "WINDOW, open pick.script",
    "WINDOW, pick.script",
    "WINDOW, --robot ur10e",
    "LANGUAGE_SERVER, lsp",
    "DEBUG_ADAPTER, dap",
    "SWEEP, sweep plan.toml",
    "SWEEP_BY_ENGINE, sweep plan.toml --engine spark",
  })
  void theWordsSayWhatIsStarted(StartKind expected, String line) {
    assertEquals(expected, kind(true, line.split(" ")));
  }

  @Test
  void withoutWordsTheWindowOpens() {
    assertEquals(StartKind.WINDOW, kind(true));
  }

  @Test
  void withoutADisplayNothingIsAWindow() {
    assertEquals(StartKind.COMMAND, kind(false, "open", "pick.script"));
    assertEquals(StartKind.LANGUAGE_SERVER, kind(false, "lsp"));
  }

  @Test
  void whatOtherSystemsDoNotKnowIsForLinuxAlone() {
    List<String> options = List.of("-XX:TrimNativeHeapInterval=60000", "-Dsun.java2d.fontpath=");

    assertTrue(StartKind.WINDOW.all(List.of(), "Linux").containsAll(options));
    assertTrue(Collections.disjoint(StartKind.WINDOW.all(List.of(), "Windows 11"), options));
  }

  @Test
  void whatTheUserGivesComesLastAndItsHeapInsteadOfOurs() {
    List<String> ours = StartKind.WINDOW.all(List.of("-Dmine=1"), "Linux");
    List<String> theirs = StartKind.WINDOW.all(List.of("-Xmx2g"), "Linux");

    assertTrue(ours.contains("-Xmn24m"), ours.toString());
    assertEquals("-Dmine=1", ours.getLast());
    assertEquals(-1, theirs.indexOf("-Xmn24m"), theirs.toString());
    assertEquals("-Xmx2g", theirs.getLast());
  }
}
