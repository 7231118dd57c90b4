package org.pendant.window;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** That keys go where people type, whatever the program does meanwhile. */
@Tag("slow")
final class FocusWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  @TempDir static Path folder;

  private final OpenWindow window = sharedWindow.window();
  private ServerSocket visited;
  private Socket visitor;

  @BeforeEach
  void listen() throws IOException {
    visited = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
  }

  @AfterEach
  void hangUp() throws IOException {
    visited.close();
    if (visitor != null) {
      visitor.close();
    }
  }

  @Test
  void aStopOfTheDebuggerLeavesThePaletteOpen() throws IOException {
    holdBeforeWaiting();
    window.press("F10");
    window.awaitWords("program-state", "running");
    window.press("control shift P");
    window.awaitFocus("palette-query");
    window.type("show");
    endTheStep();
    window.awaitWords("program-state", "paused");
    window.settle();
    window.awaitFocus("palette-query");
    window.type(" lo");
    window.awaitWords("palette-query", "show lo");
    window.press("ESCAPE");
    window.awaitHidden("palette-query");
  }

  @Test
  void aStopOfTheDebuggerLeavesTheFieldSomebodyTypesIn() throws IOException {
    holdBeforeWaiting();
    window.perform("Find in files");
    window.awaitFocus("search-words");
    window.press("F10");
    window.awaitWords("program-state", "running");
    window.type("when");
    endTheStep();
    window.awaitWords("program-state", "paused");
    window.settle();
    window.awaitFocus("search-words");
    window.perform("Show the dock at the bottom");
  }

  @Test
  void theScriptOfATreeTakesTheKeysThoughItCannotBeEdited() {
    window.perform("Example: stack boxes");
    window.awaitWords("program-name", "stack_boxes");
    window.press("alt 3");
    window.awaitFocus("script-text");
  }

  @Test
  void whatIsTypedAfterGoToLineComesToTheScript() {
    sharedWindow.program("one = 1", "two = 2");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control G");
    window.awaitFocus("prompt");
    window.press("control A");
    window.type("2\n");
    window.type("x");
    window.awaitWords("script-text", "one = 1\nxtwo = 2");
    window.press("control Z");
    window.press("control S");
  }

  @Test
  void aWordThatIsTakenBackTakesWhatItOfferedAlong() {
    sharedWindow.program("one = 1", "");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control END");
    window.type("s");
    window.awaitShown("completions");
    window.press("control Z");
    window.awaitHidden("completions");
    window.settle();
    window.awaitHidden("completions");
    window.press("control S");
  }

  @Test
  void keysGoToThePanelThatIsDrawn() {
    window.press("control alt T");
    window.awaitFocus("timeline-canvas");
    window.press("HOME");
    window.awaitShown("past-banner");
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
    window.perform("Show 3D");
    window.awaitFocus("scene");
    window.press("control J");
  }

  @Test
  void whatIsTypedAfterNewComesToTheNewProgram() {
    window.click("rail-log");
    window.perform("New script");
    window.awaitFocus("script-text");
    window.type("sync()");
    window.awaitWords("script-text", "():\n  sync()\nend");
    window.press("control Z");
    window.click("rail-io");
    window.press("control N");
    window.awaitFocus("program-tree");
    window.click("program-palette");
    window.awaitFocus("program-palette");
    window.perform("New program");
    window.awaitFocus("program-tree");
  }

  @Test
  void keysComeToTheContentOfAPanelWhoseTabIsChosenNotToItsFirstButton() {
    window.press("control alt T");
    window.awaitFocus("timeline-canvas");
    window.choose("dock-tabs-bottom", "Breakpoints");
    window.awaitShown("breakpoints");
    window.awaitHidden("timeline-canvas");
    window.choose("dock-tabs-bottom", "Timeline");
    window.awaitFocus("timeline-canvas");
    window.perform("Show the dock at the bottom");
  }

  @Test
  void keysOfAButtonThatIsUsedUpGoToItsScreenNotToTheButtonBesideIt() {
    window.perform("New scene");
    window.click("cell-object-add-box");
    window.awaitEnabled("cell-undo");
    window.click("cell-undo");
    window.awaitFocus("cell-object-list");
    window.press("alt 3");
  }

  @Test
  void anOpenedScriptIsShownWithTheKeysInIt() throws IOException {
    Path file = Files.writeString(folder.resolve("opened.script"), "one = 1\n");
    window.click("rail-log");
    window.press("control O");
    window.awaitFocus("open-dialog");
    window.type(file + "\n");
    window.awaitWords("program-name", "opened.script");
    window.awaitHidden("open-dialog");
    window.raise();
    window.awaitFocus("script-text");
    window.type("#");
    window.awaitWords("script-text", "#one = 1");
    window.press("control S");
  }

  @Test
  void tabGoesFromFindToReplaceBy() {
    sharedWindow.program("one = 1");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control H");
    window.awaitFocus("find-words");
    window.type("one");
    window.press("TAB");
    window.awaitFocus("find-replacement");
    window.type("two");
    window.press("alt ENTER");
    window.awaitWords("script-text", "two = 1");
    window.press("shift TAB");
    window.awaitFocus("find-words");
    window.press("ESCAPE");
    window.press("control S");
  }

  @Test
  void enterTakesTheFirstQuickFix() {
    sharedWindow.program("slepe(1)");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.press("alt ENTER");
    window.awaitShown("quick-fixes");
    window.press("ENTER");
    window.awaitWords("script-text", "sleep(1)");
    window.press("control S");
  }

  /** The next step lasts until {@link #endTheStep}, however long it takes to go elsewhere. */
  private void holdBeforeWaiting() throws IOException {
    sharedWindow.program(
        "socket_open(\"127.0.0.1\", " + visited.getLocalPort() + ")",
        "socket_read_byte_list(1, timeout=0)",
        "i = 2",
        "sleep(1)");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.press("DOWN");
    window.press("F9");
    window.press("F5");
    window.awaitWords("program-state", "paused");
    visitor = visited.accept();
  }

  private void endTheStep() throws IOException {
    visitor.getOutputStream().write('.');
  }
}
