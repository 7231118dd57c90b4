package org.pendant.window;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Popups and questions of programs, answered by keyboard, with Stop always in sight. */
@Tag("slow")
final class PromptWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @Test
  void popupIsAnsweredByEnter() {
    sharedWindow.run("popup(\"take the part\", \"Please\", blocking=True)", "textmsg(\"taken\")");
    window.awaitWords("popup-title", "Please");
    window.awaitWords("popup-text", "take the part");
    window.awaitEnabled("program-stop");
    window.awaitFocus("popup-continue");
    window.press("ENTER");
    window.awaitHidden("popup-text");
    window.awaitWords("run-messages", "taken");
  }

  @Test
  void programIsStoppedFromThePopupByKey() {
    sharedWindow.run("popup(\"take the part\", blocking=True)", "textmsg(\"taken after all\")");
    window.awaitFocus("popup-continue");
    window.press("shift TAB");
    window.awaitFocus("popup-stop");
    window.press("ENTER");
    window.awaitHidden("popup-text");
    window.awaitWords("program-state", "stopped");
  }

  @Test
  void popupsQueueAndThoseThatDoNotBlockLeaveTheProgramRunning() {
    sharedWindow.run("popup(\"first\")", "popup(\"second\")", "while True:", "  sync()", "end");
    window.awaitWords("popup-text", "first");
    window.awaitWords("popup-place", "1 of 2");
    window.awaitWords("program-state", "running");
    window.awaitFocus("popup-continue");
    window.press("ESCAPE");
    window.awaitWords("popup-text", "second");
    window.awaitWords("program-state", "running");
    window.awaitFocus("popup-continue");
    window.press("SPACE");
    window.awaitHidden("popup-text");
    window.awaitWords("program-state", "running");
  }

  @Test
  void yesOrNoIsAnsweredByItsLetterAndNoHasTheFocus() {
    sharedWindow.run(
        "a = request_boolean_from_primary_client(\"Mark the part?\")",
        "b = request_boolean_from_primary_client(\"And pack it?\")",
        "textmsg(a, b)");
    window.awaitWords("popup-text", "Mark the part?");
    window.awaitEnabled("program-stop");
    window.awaitFocus("popup-no");
    window.press("Y");
    window.awaitWords("popup-text", "And pack it?");
    window.awaitFocus("popup-no");
    window.press("ENTER");
    window.awaitHidden("popup-text");
    window.awaitWords("run-messages", "TrueFalse");
  }

  @Test
  void wholeNumberIsCheckedAtTheField() {
    sharedWindow.run(
        "textmsg(\"parts \", request_integer_from_primary_client(\"How many parts?\"))");
    window.awaitFocus("popup-field");
    window.type("2.5\n");
    window.awaitWords("popup-error", "Must be a whole number");
    window.awaitWords("program-state", "running");
    window.press("control A");
    window.type("25");
    window.awaitHidden("popup-error");
    window.press("ENTER");
    window.awaitHidden("popup-text");
    window.awaitWords("run-messages", "parts 25");
  }

  @Test
  void numberIsTyped() {
    sharedWindow.run("textmsg(\"offset \", request_float_from_primary_client(\"Offset [mm]\"))");
    window.awaitFocus("popup-field");
    window.type("-12.5\n");
    window.awaitWords("run-messages", "offset -12.5");
  }

  @Test
  void textIsTyped() {
    sharedWindow.run("textmsg(\"part \", request_string_from_primary_client(\"Which part?\"))");
    window.awaitFocus("popup-field");
    window.type("Bolt M8\n");
    window.awaitWords("run-messages", "part Bolt M8");
  }

  @Test
  void cancelStopsTheProgram() {
    sharedWindow.run("request_string_from_primary_client(\"Which part?\")", "textmsg(\"went on\")");
    window.awaitFocus("popup-field");
    window.click("popup-stop");
    window.awaitHidden("popup-text");
    window.awaitWords("program-state", "stopped");
  }

  @Test
  void questionLeavesTheKeyboardToSomebodyWhoTypesUntilItIsAskedFor() {
    sharedWindow.program(
        "sleep(1)", "textmsg(\"named \", request_string_from_primary_client(\"Who?\"))");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("F5");
    window.awaitWords("popup-text", "Who?");
    window.awaitWords("popup-hint", "F7");
    window.awaitEnabled("popup-continue");
    window.awaitFocus("script-text");
    window.press("F7");
    window.awaitFocus("popup-field");
    window.press("ESCAPE");
    window.awaitFocus("script-text");
    window.awaitShown("popup-text");
    window.press("F7");
    window.awaitFocus("popup-field");
    window.type("me\n");
    window.awaitHidden("popup-text");
    window.awaitFocus("script-text");
    window.click("rail-run");
    window.awaitWords("run-messages", "named me");
  }

  @Test
  void stopIsToldOnOtherScreensAndLeadsToItsLine() {
    sharedWindow.program("sleep(0.5)", "protective_stop()", "sleep(1)");
    window.click("rail-log");
    window.press("F5");
    window.awaitWords("stop-notice", "The program asks for it");
    window.clickText("stop-notice", "Show what happened");
    window.awaitShown("stop-card");
    window.awaitHidden("stop-notice");
    window.awaitWords("stop-remedy", "Unlock");
    window.awaitWords("stop-source", "Show line 2");
    window.click("stop-source");
    window.awaitFocus("script-text");
    window.press("shift F5");
    window.await(
        "the arm is ready",
        () -> {
          window.press("F4");
          return window.words("readiness").equals("Ready");
        });
  }
}
