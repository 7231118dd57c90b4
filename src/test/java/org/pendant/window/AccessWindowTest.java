package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** That everything can be reached and read, by key, by a screen reader and in a small window. */
@Tag("slow")
final class AccessWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @Test
  void everythingThatKeysReachHasANameOnEveryScreen() {
    List<String> screens = window.named("rail-");
    assertTrue(screens.size() >= 6, screens.toString());
    for (String each : screens) {
      window.click(each);
      assertEquals("", window.nameless(), each);
    }
  }

  @Test
  void everythingThatKeysReachHasANameInEveryPanel() {
    window.perform("Show Problems");
    for (String dock : List.of("dock-tabs-right", "dock-tabs-lower", "dock-tabs-bottom")) {
      for (String title : window.tabs(dock)) {
        window.choose(dock, title);
        assertEquals("", window.nameless(), title);
      }
    }
    window.perform("Show the dock at the bottom");
  }

  @Test
  void everythingThatKeysReachHasANameInPanelsOverTheWindow() {
    window.press("control shift P");
    window.awaitFocus("palette-query");
    assertEquals("", window.nameless());
    window.type("change keys");
    window.press("ENTER");
    window.awaitFocus("key-filter");
    assertEquals("", window.nameless());
    window.press("ESCAPE");
    window.awaitHidden("key-filter");
  }

  @Test
  void noTwoActionsOfOneScreenHaveTheSameKey() {
    window.perform("Change keys");
    window.awaitFocus("key-filter");
    window.awaitWords("key-table", "Undo in the program");
    assertFalse(window.words("key-table").contains("conflict"), () -> window.words("key-table"));
    window.press("ESCAPE");
    window.awaitHidden("key-filter");
  }

  @Test
  void keysComeToTheTextTableOrTreeOfAScreenThatIsShown() {
    window.press("alt 3");
    window.awaitFocus("script-text");
    window.press("alt 7");
    window.awaitFocus("log-table");
    window.press("alt 3");
    window.awaitFocus("script-text");
  }

  @Test
  void stopIsThereInASmallWindowWithLargeLetters() {
    window.resize("1024x700");
    for (int i = 0; i < 6; i++) {
      window.perform("Everything larger");
      window.await("Stop is there as a whole", () -> window.whole("program-stop"));
      window.await("the safety mode is there", () -> window.whole("safety-mode"));
    }
    window.awaitShown("footer-more");
    window.awaitShown("rail-more");
    window.press("alt 7");
    window.awaitFocus("log-table");
    window.perform("Everything in normal size");
    window.awaitHidden("footer-more");
    window.awaitHidden("rail-more");
    window.resize("1440x900");
  }
}
