package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.message.Operator;

final class RunFactsTest {
  private final Controller controller =
      new Controller(
          ControllerOptions.headless().withArm(ArmChoice.IDEAL).withOperator(Operator.present()));

  private void start(String text) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    controller.advance();
  }

  private RunFacts facts(String lineText) {
    return RunFacts.of(controller.state(), lineText, IntUnaryOperator.identity());
  }

  private void runFrames(int frames) {
    controller.runUntil(() -> false, frames);
  }

  @Test
  void beforeTheFirstProgramItSaysSo() {
    controller.advance();
    assertEquals("Stopped; nothing has run yet", facts("").state());
    assertEquals("", facts("").line());
    assertEquals("-90.00\u00b0", facts("").joints().get(1));
    assertEquals("0.00\u00b0", facts("").joints().get(0));
  }

  @Test
  void aRunningProgramShowsItsLine() {
    start("sleep(1)\n");
    assertEquals("Running", facts("").state());
    assertEquals("Line 1:  sleep(1)", facts("   sleep(1)").line());
  }

  @Test
  void linesAreThoseThatPeopleSee() {
    start("sleep(1)\n");
    assertEquals(
        "Line 11:  sleep(1)",
        RunFacts.of(controller.state(), "sleep(1)", line -> line + 10).line());
    assertEquals("", RunFacts.of(controller.state(), "sleep(1)", line -> 0).line());
  }

  @Test
  void endingsAreToldApart() {
    start("sleep(0.1)\n");
    runFrames(100);
    assertEquals("Finished", facts("").state());
    start("halt\n");
    runFrames(10);
    assertEquals("Ended by halt", facts("").state());
    start("x = [1]\ny = x[3]\n");
    runFrames(10);
    assertTrue(facts("").failed());
    assertTrue(facts("").state().startsWith("Failed in line 2: "), facts("").state());
  }

  @Test
  void openPopupsAndQuestionsAreCounted() {
    assertEquals("", facts("").waiting());
    start("popup(\"a\")\nrequest_string_from_primary_client(\"b\")\n");
    runFrames(10);
    assertEquals("A popup and a question open", facts("").waiting());
    var _ = controller.submit(new ProgramCommand.StopProgram());
    start("popup(\"a\")\npopup(\"b\", blocking=True)\n");
    runFrames(10);
    assertEquals("2 popups open", facts("").waiting());
  }

  @Test
  void theTimerStandsWhenTheProgramEnds() {
    RunTimer timer = new RunTimer();
    timer.take(controller.state());
    start("sleep(2)\n");
    timer.take(controller.state());
    runFrames(750);
    assertEquals("0:01.5", timer.take(controller.state()));
    runFrames(500);
    String end = timer.take(controller.state());
    runFrames(500);
    assertEquals(end, timer.take(controller.state()));
    assertEquals("61:01.5", RunTimer.text(3661.5));
  }

  @Test
  void onlyTheLastMessagesAreShown() {
    RecentMessages messages = new RecentMessages();
    assertFalse(messages.take(0, controller::logSince));
    start("i = 0\nwhile i < 20:\n  textmsg(\"n \", i)\n  i = i + 1\nend\n");
    runFrames(50);
    assertTrue(messages.take(controller.state().newestEntry(), controller::logSince));
    List<String> lines = messages.messages().stream().map(RecentMessages.Message::line).toList();
    assertEquals(8, lines.size());
    assertEquals("n 19", lines.getLast());
  }
}
