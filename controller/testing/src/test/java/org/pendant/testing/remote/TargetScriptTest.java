package org.pendant.testing.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

class TargetScriptTest {
  private static TargetScript script(String text) {
    return TargetScript.of(Source.of("cell/pick-1.script", text)).orElseThrow();
  }

  @Test
  void aSingleDefinitionIsSentWithWhatStandsAboveItInside() {
    TargetScript sent = script("# pick\ndef pick():\n  sleep(1)\nend\n");

    assertEquals("def pick():\n  # pick\n  sleep(1)\nend\n", sent.text());
    assertEquals(2, sent.lineOf(1));
    assertEquals(1, sent.lineOf(2));
    assertEquals(3, sent.lineOf(3));
    assertEquals(3, sent.columnOf(3, 3));
    assertEquals(1, sent.columnOf(2, 3));
  }

  @Test
  void theLastDefinitionRunsAndHasTheOthersInside() {
    TargetScript sent = script("def grip():\n  sleep(1)\nend\ndef pick():\n  grip()\nend");

    assertEquals("def pick():\n  def grip():\n    sleep(1)\n  end\n  grip()\nend\n", sent.text());
    assertEquals(4, sent.lineOf(1));
    assertEquals(2, sent.lineOf(3));
    assertEquals(5, sent.lineOf(5));
  }

  @Test
  void onlyTheLastLineOfTheTextEndsAProgram() {
    TargetScript sent = script("def pick():\nif True:\nsleep(1)\nend\nend\n");

    assertEquals("def pick():\n  if True:\n  sleep(1)\n  end\nend\n", sent.text());
    assertEquals(1, sent.columnOf(3, 3));
  }

  @Test
  void statementsBecomeTheBodyOfAProgram() {
    TargetScript sent = script("def grip():\n  sleep(1)\nend\ngrip()\n");

    assertTrue(
        sent.text()
            .startsWith("def run_pick_1():\n  def grip():\n    sleep(1)\n  end\n  grip()\n"));
    assertTrue(sent.text().endsWith("\nend\n"));
    assertEquals(4, sent.lineOf(5));
  }

  @Test
  void aSecondaryProgramIsNotStartedAlone() {
    assertEquals(
        Optional.empty(),
        TargetScript.of(Source.of("a.script", "sec a():\n  set_flag(0, True)\nend\n")));
  }
}
