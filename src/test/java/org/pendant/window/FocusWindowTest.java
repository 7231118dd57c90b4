package org.pendant.window;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** That keys go where people type, whatever the program does meanwhile. */
final class FocusWindowTest {
  @RegisterExtension static final SharedWindow desk = new SharedWindow();

  private final OpenWindow window = desk.window();

  @Test
  void aStopOfTheDebuggerLeavesThePaletteOpen() {
    holdBeforeSleep();
    window.press("F10");
    window.awaitWords("program-state", "running");
    window.press("control shift P");
    window.awaitFocus("palette-query");
    window.type("show");
    window.awaitWords("program-state", "held");
    window.settle();
    window.awaitFocus("palette-query");
    window.type(" lo");
    window.awaitWords("palette-query", "show lo");
    window.press("ESCAPE");
    window.awaitHidden("palette-query");
  }

  @Test
  void aStopOfTheDebuggerLeavesTheFieldSomebodyTypesIn() {
    holdBeforeSleep();
    window.perform("Find in files");
    window.awaitFocus("search-words");
    window.press("F10");
    window.awaitWords("program-state", "running");
    window.type("when");
    window.awaitWords("program-state", "held");
    window.settle();
    window.awaitFocus("search-words");
    window.perform("Fold or unfold the dock at the bottom");
  }

  @Test
  void whatIsTypedAfterGoToLineComesToTheScript() {
    desk.program("one = 1", "two = 2");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control G");
    window.awaitFocus("prompt");
    window.press("control A");
    window.type("2\n");
    // Java cannot tell keys of one millisecond apart; this question takes a little longer.
    window.words("script-editor");
    window.type("x");
    window.awaitWords("script-text", "one = 1\nxtwo = 2");
    window.press("control Z");
    window.press("control S");
  }

  /** The next step lasts two seconds, long enough to go elsewhere. */
  private void holdBeforeSleep() {
    desk.program("i = 1", "sleep(2)", "i = 2", "sleep(1)");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.press("DOWN");
    window.press("F9");
    window.press("F5");
    window.awaitWords("program-state", "held");
  }
}
