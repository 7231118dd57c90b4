package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.script.debug.Breakpoint;

class EditorLinkTest {
  private static final Breakpoint STOPS = Breakpoint.at(4);

  private static String about(Breakpoint breakpoint, long hits) {
    return EditorLink.mark(breakpoint, hits).about();
  }

  @Test
  void aMarkSaysWhatTheBreakpointDoes() {
    assertEquals("The program stops before this line", about(STOPS, 0));
    assertEquals("Disabled: stops", about(STOPS.enabled(false), 0));
    assertEquals(
        "The program logs \u201cturn {i}\u201d before this line",
        about(STOPS.logging("turn {i}"), 0));
    assertEquals(
        "Disabled: logs \u201cturn {i}\u201d", about(STOPS.logging("turn {i}").enabled(false), 0));
  }

  @Test
  void aMarkSaysWhenAndHowOften() {
    assertEquals(
        "The program stops before this line when i > 3; hit once", about(STOPS.when("i > 3"), 1));
    assertEquals("The program stops before this line; hit 7 times", about(STOPS, 7));
  }
}
