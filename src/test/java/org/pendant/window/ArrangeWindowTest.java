package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Panels that are dragged and folded, and keys that are changed. */
@Tag("slow")
final class ArrangeWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @AfterEach
  void putBack() {
    window.perform("Put all panels where they belong at first");
  }

  @Test
  void aTabIsDraggedToTheOtherSideAndComesBack() {
    window.dragTab("dock-tabs-lower", "Outline", "rail-run");
    window.await("it is where it was", () -> window.tabs("dock-tabs-lower").contains("Outline"));
    window.dragTab("dock-tabs-lower", "Outline", "dock-tabs-bottom");
    window.await("it is there", () -> window.tabs("dock-tabs-bottom").contains("Outline"));
    window.awaitShown("outline-tree");
    window.dragTab("dock-tabs-bottom", "Outline", "main-area");
    window.await("it is there", () -> !window.tabs("dock-tabs-bottom").contains("Outline"));
    window.awaitShown("outline-tree");
    window.click("rail-run");
    window.awaitHidden("outline-tree");
  }

  @Test
  void theTreeKeepsItsShareAndTheKeyboardInAWindowThatGetsSmallAndLargeAgain() {
    window.press("control N");
    window.awaitFocus("program-tree");
    window.settle();
    String form = window.place("node-form");
    window.resize("1024x700");
    window.awaitHidden("program-palette");
    window.awaitFocus("program-tree");
    window.resize("1440x900");
    window.awaitShown("program-palette");
    window.awaitFocus("program-tree");
    window.settle();
    assertEquals(form, window.place("node-form"));
  }

  @Test
  void aPanelGoesIntoAWindowOfItsOwnAndBackWhenThatIsClosed() {
    List<String> before = window.tabs("dock-tabs-lower");
    window.perform("Move Outline to a window of its own");
    window.awaitShown("window-outline");
    window.awaitShown("outline-tree");
    assertFalse(window.tabs("dock-tabs-lower").contains("Outline"));
    window.awaitShown("variables-view");
    window.askToClose("window-outline");
    window.awaitHidden("window-outline");
    window.raise();
    window.awaitShown("outline-tree");
    assertEquals(new HashSet<>(before), new HashSet<>(window.tabs("dock-tabs-lower")));
  }

  @Test
  void aTabIsDraggedAmongItsNeighbours() {
    List<String> before = window.tabs("dock-tabs-lower");
    window.dragTab("dock-tabs-lower", before.getLast(), "dock-tabs-lower");
    window.choose("dock-tabs-lower", before.getFirst());
    assertEquals(before, window.tabs("dock-tabs-lower"), "dropped beside the tabs: at the end");
  }

  @Test
  void aSideIsFoldedByItsArrowAndUnfoldedByAKey() {
    window.awaitShown("scene");
    window.click("dock-collapse-right");
    window.awaitHidden("scene");
    window.press("control B");
    window.awaitShown("scene");
  }

  @Test
  void theArmAndTheVariablesAreSeenTogetherAndEachScreenKeepsWhatIsFolded() {
    window.awaitShown("scene");
    window.awaitShown("variables-view");
    window.click("dock-collapse-lower");
    window.awaitHidden("variables-view");
    window.awaitShown("scene");
    window.click("rail-script");
    window.awaitShown("variables-view");
    window.click("rail-run");
    window.awaitHidden("variables-view");
    window.press("control alt J");
    window.awaitShown("variables-view");
  }

  @Test
  void aNewKeyDoesItsActionAndTheOldOneDoesNotAnyMore() {
    window.perform("Change keys");
    window.awaitFocus("key-filter");
    window.type("show log");
    window.click("key-capture");
    window.awaitFocus("key-capture");
    window.press("A");
    window.awaitWords("key-conflict", "is needed for writing");
    window.press("control alt K");
    window.awaitWords("key-table", "Show Log | Ctrl+Alt+K | changed");
    window.press("ESCAPE");
    window.awaitHidden("key-table");
    window.press("control alt K");
    window.awaitShown("log-view");
    window.click("rail-run");
    window.awaitHidden("log-view");
    window.press("alt 7");
    window.perform("Change keys");
    window.awaitFocus("key-filter");
    assertEquals(false, window.shows("log-view"));
    window.click("key-reset-all");
    window.press("ESCAPE");
    window.awaitHidden("key-table");
    window.press("alt 7");
    window.awaitShown("log-view");
  }

  @Test
  void aKeyOfTwoActionsIsTakenFromTheOther() {
    window.perform("Change keys");
    window.awaitFocus("key-filter");
    window.type("show plots");
    window.click("key-capture");
    window.awaitFocus("key-capture");
    window.press("alt 7");
    window.awaitWords("key-conflict", "Show Log");
    window.click("key-take");
    window.awaitWords("key-table", "Show Plots | Alt+7 | changed");
    window.click("key-reset-all");
    window.press("ESCAPE");
    window.awaitHidden("key-table");
  }
}
