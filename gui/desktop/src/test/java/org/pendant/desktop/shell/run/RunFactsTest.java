package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.script.debug.Debugger;

final class RunFactsTest {
  private final Controller controller =
      new Controller(
          ControllerOptions.headless().withArm(ArmChoice.IDEAL).withOperator(Operator.present()));

  private boolean left;
  private Optional<String> node = Optional.empty();
  private RunTime time = RunTime.NONE;

  private void start(String text) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    controller.advance();
  }

  private RunFacts facts() {
    return facts(IntUnaryOperator.identity());
  }

  private RunFacts facts(IntUnaryOperator shown) {
    return RunFacts.of(controller.state(), new FakeRun(shown), PoseForm.STANDARD);
  }

  /** Program weld.script, which ran last, while pick.script is in front. */
  private final class FakeRun extends NoRun {
    private final IntUnaryOperator shown;

    FakeRun(IntUnaryOperator shown) {
      this.shown = shown;
    }

    @Override
    public Optional<String> next() {
      return Optional.of("pick.script");
    }

    @Override
    public String name(ControllerState state) {
      return "weld.script";
    }

    @Override
    public boolean left(ControllerState state) {
      return left;
    }

    @Override
    public Optional<RunNode> nodeAt(int line) {
      return node.map(
          label -> new RunNode(ProgramDocument.untitled("weld.pendant", ""), 1, 15, label));
    }

    @Override
    public RunTime time() {
      return time;
    }

    @Override
    public String lineText(int line) {
      return "   sleep(1)";
    }

    @Override
    public int shownLine(int line) {
      return shown.applyAsInt(line);
    }
  }

  private void runFrames(int frames) {
    controller.runUntil(() -> false, frames);
  }

  @Test
  void beforeTheFirstProgramItSaysSo() {
    controller.advance();
    assertEquals("Will run: pick.script", facts().title());
    assertEquals("Stopped", facts().state());
    assertEquals("", facts().elapsed());
    assertEquals("", facts().line());
    assertEquals("-90.00\u00b0", facts().joints().get(1));
    assertEquals("0.00\u00b0", facts().joints().get(0));
  }

  @Test
  void aRunningProgramShowsItsLine() {
    start("sleep(1)\n");
    assertEquals("weld.script", facts().title());
    assertEquals("Running", facts().state());
    assertEquals("Line 1:  sleep(1)", facts().line());
  }

  @Test
  void linesAreThoseThatPeopleSee() {
    start("sleep(1)\n");
    assertEquals("Line 11:  sleep(1)", facts(line -> line + 10).line());
    assertEquals("", facts(line -> 0).line());
  }

  @Test
  void endingsAreToldApart() {
    start("sleep(0.1)\n");
    runFrames(100);
    assertEquals("Will run: pick.script", facts().title());
    assertEquals("Last run: weld.script, finished", facts().state());
    start("halt\n");
    runFrames(10);
    assertEquals("Last run: weld.script, ended by halt", facts().state());
    start("x = [1]\ny = x[3]\n");
    runFrames(10);
    assertTrue(facts().failed());
    assertEquals("Last run: weld.script, failed in line 2", facts().state());
    assertTrue(facts().line().contains("index"), facts().line());
    node = Optional.of("Feeder");
    assertEquals("Last run: weld.script, failed in node 15 Feeder", facts().state());
  }

  @Test
  void openPopupsAndQuestionsAreCounted() {
    assertEquals("", facts().waiting());
    start("popup(\"a\")\nrequest_string_from_primary_client(\"b\")\n");
    runFrames(10);
    assertEquals("A popup and a question open", facts().waiting());
    var _ = controller.submit(new ProgramCommand.StopProgram());
    start("popup(\"a\")\npopup(\"b\", blocking=True)\n");
    runFrames(10);
    assertEquals("2 popups open", facts().waiting());
  }

  @Test
  void theLastRunIsOverForThoseWhoHaveTurnedToAnotherProgram() {
    start("x = [1]\ny = x[3]\n");
    runFrames(10);
    left = true;
    time = new RunTime(0, 0, Double.NaN, 1);
    assertEquals("Stopped", facts().state());
    assertFalse(facts().failed());
    assertEquals("", facts().elapsed());
  }

  @Test
  void aProgramIsPausedAtItsLineWhoeverHasPausedIt() {
    start("sleep(1)\nsleep(1)\n");
    runFrames(600);
    var _ = controller.submit(new ProgramCommand.PauseProgram());
    runFrames(10);
    assertEquals("Paused at line 2", facts().state());
    assertEquals("Paused at line 12", facts(line -> line + 10).state());
    assertEquals("Paused", facts(line -> 0).state());
    node = Optional.of("Feeder");
    assertEquals("Paused at node 15 Feeder", facts().state());
    node = Optional.empty();
    var _ = controller.submit(new ProgramCommand.ResumeProgram());
    var _ = controller.submit(new DebugCommand.Debug(Debugger::pause));
    runFrames(1);
    assertEquals("Paused at line 2", facts().state());
  }

  @Test
  void thePausesOfARunAreToldApart() {
    time = new RunTime(-20, 0, -10, Double.NaN);
    assertEquals("0:10.0", facts().elapsed());
    assertEquals("paused 10 s", facts().paused());
    time = new RunTime(-20, 0.5, Double.NaN, Double.NaN);
    assertEquals("", facts().paused());
    time = new RunTime(-200, 65, Double.NaN, Double.NaN);
    assertEquals("paused 1:05.0", facts().paused());
    assertEquals("61:01.5", RunFacts.clock(3661.5));
  }

  @Test
  void onlyTheLastMessagesAreShown() {
    RecentMessages messages = new RecentMessages();
    assertTrue(messages.take(controller, 0, controller::logSince));
    start("i = 0\nwhile i < 20:\n  textmsg(\"n \", i)\n  i = i + 1\nend\n");
    runFrames(50);
    long newest = controller.state().newestEntry();
    assertTrue(messages.take(controller, newest, controller::logSince));
    assertFalse(messages.take(controller, newest, controller::logSince));
    List<String> lines = lines(messages);
    assertEquals(8, lines.size());
    assertEquals("n 19", lines.getLast());
  }

  @Test
  void messagesOfThePastAreThoseUntilThenAndNoneIsThereTwice() {
    RecentMessages messages = new RecentMessages();
    start("textmsg(\"a\")\ntextmsg(\"b\")\ntextmsg(\"c\")\n");
    runFrames(10);
    long newest = controller.state().newestEntry();
    messages.take(controller, newest, controller::logSince);
    messages.take(controller, newest - 1, controller::logSince);
    assertEquals(List.of("a", "b"), lines(messages));
    messages.take(controller, newest, controller::logSince);
    assertEquals(List.of("a", "b", "c"), lines(messages));
    messages.take("a recording", newest, number -> List.of());
    assertEquals(List.of(), lines(messages));
  }

  private static List<String> lines(RecentMessages messages) {
    return messages.messages().stream().map(RecentMessages.Message::line).toList();
  }
}
