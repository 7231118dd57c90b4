package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.Popup;
import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.InterpreterEvent;
import org.pendant.script.vm.InterpreterEvent.Accepted;
import org.pendant.script.vm.InterpreterJournal;
import org.pendant.script.vm.InterpreterStatus;
import org.pendant.script.vm.ProgramState;

/** Interpreter mode as those outside use it (manual 13). */
final class InterpreterCommandsTest {
  private static final String DOUBLE = "def double(x): return 2 * x end";

  private final Controller controller = new Controller(ControllerOptions.headless());

  private void start(String... lines) {
    TestController.start(controller, String.join("\n", lines));
    controller.advance();
  }

  private void interpreting() {
    start("def im():", "  interpreter_mode()", "end");
  }

  private CompletableFuture<Reply> send(String line) {
    return controller.submit(new InterpreterCommand.Interpret(line));
  }

  private static Reply acknowledged(int id) {
    return new Reply.Interpreted(new Interpreter.Response.Acknowledged(id));
  }

  private InterpreterStatus status() {
    return assertInstanceOf(
            Reply.InterpreterState.class,
            TestController.ask(controller, new InterpreterCommand.AskInterpreter()))
        .status();
  }

  private List<InterpreterEvent> events() {
    return controller.interpreterJournal().since(0).stream()
        .map(InterpreterJournal.Entry::event)
        .toList();
  }

  @Test
  void theStatusCountsWhatWasAcceptedAndBegun() {
    assertEquals(new InterpreterStatus(false, 0, 0, 0, 0), status());
    interpreting();
    var _ = send("sleep(1)");
    var _ = send("textmsg(1)");
    controller.advance();
    assertEquals(new InterpreterStatus(true, 1, 2, 0, 1), status());
  }

  @Test
  void linesBehindAClearAreCheckedWhenItIsDone() {
    interpreting();
    CompletableFuture<Reply> first = send(DOUBLE);
    CompletableFuture<Reply> clear = send("clear_interpreter()");
    CompletableFuture<Reply> tooLate = send("textmsg(double(2))");
    CompletableFuture<Reply> last = send("textmsg(3)");
    controller.advance();
    assertEquals(acknowledged(1), first.join());
    assertEquals(acknowledged(2), clear.join());
    assertFalse(tooLate.isDone());
    assertFalse(last.isDone());
    controller.advance();
    controller.advance();
    assertInstanceOf(
        Interpreter.Response.Discarded.class,
        assertInstanceOf(Reply.Interpreted.class, tooLate.join()).reply());
    assertEquals(acknowledged(3), last.join());
  }

  @Test
  void linesThatWaitForAClearAreAnsweredWhenTheProgramStops() {
    interpreting();
    var _ = send("sleep(10)");
    var _ = send("clear_interpreter()");
    CompletableFuture<Reply> waiting = send("textmsg(1)");
    controller.advance();
    assertFalse(waiting.isDone());
    TestController.ask(controller, new ProgramCommand.StopProgram());
    controller.advance();
    assertEquals(
        new Reply.Interpreted(new Interpreter.Response.Discarded("no program is running")),
        waiting.join());
  }

  @Test
  void skippingTheClearLetsTheOthersGoOn() {
    interpreting();
    var _ = send("sleep(10)");
    var _ = send("clear_interpreter()");
    CompletableFuture<Reply> waiting = send("textmsg(1)");
    controller.advance();
    TestController.ask(controller, new InterpreterCommand.SkipInterpreted());
    controller.advance();
    assertEquals(acknowledged(3), waiting.join());
  }

  @Test
  void aLineThatRefersToWhatHasGoneMeanwhileIsDroppedWithAWarning() {
    interpreting();
    var _ = send(DOUBLE);
    var _ = send("def wipe(): clear_interpreter() end");
    for (int i = 0; i < 4; i++) {
      controller.advance();
    }
    var _ = send("wipe()");
    CompletableFuture<Reply> accepted = send("textmsg(double(2))");
    for (int i = 0; i < 4; i++) {
      controller.advance();
    }
    assertEquals(acknowledged(4), accepted.join());
    List<LogEntry> log = controller.logSince(0);
    assertTrue(
        log.getLast().text().startsWith("interpreter: statement 4 is dropped: "), log.toString());
    assertTrue(status().active());
  }

  @Test
  void theJournalTellsWhatWasAcceptedAndCleared() {
    interpreting();
    var _ = send("textmsg(1)");
    var _ = send("clear_interpreter()");
    for (int i = 0; i < 4; i++) {
      controller.advance();
    }
    TestController.ask(controller, new InterpreterCommand.Interpret("end_interpreter()"));
    controller.advance();
    assertEquals(
        List.of(
            new InterpreterEvent.ProgramStarted("im"),
            new Accepted(1, 0, "textmsg(1)"),
            new Accepted(2, 0, "clear_interpreter()"),
            new InterpreterEvent.Cleared(),
            new Accepted(3, 2, "end_interpreter()"),
            new InterpreterEvent.Cleared()),
        events());
  }

  @Test
  void theJournalTellsWhatAProgramKeeps() {
    start("def im():", "  interpreter_mode(clearOnEnd = False)", "  sleep(1)", "end");
    TestController.ask(controller, new InterpreterCommand.Interpret("end_interpreter()"));
    controller.advance();
    controller.advance();
    assertEquals(new InterpreterEvent.Kept(), events().getLast());
  }

  @Test
  void theJournalKeepsTheNewestEvents() {
    interpreting();
    for (int i = 0; i < InterpreterJournal.KEPT; i++) {
      TestController.ask(controller, new InterpreterCommand.Interpret("a = 1"));
      if (i % 1000 == 0) {
        TestController.ask(controller, new InterpreterCommand.Interpret("clear_interpreter()"));
        controller.advance();
        controller.advance();
      }
    }
    List<InterpreterJournal.Entry> kept = controller.interpreterJournal().since(0);
    assertEquals(InterpreterJournal.KEPT, kept.size());
    assertEquals(controller.interpreterJournal().newest(), kept.getLast().number());
    assertEquals(
        List.of(kept.getLast()),
        controller.interpreterJournal().since(kept.getLast().number() - 1));
  }

  @Test
  void aPopupFromOutsideHoldsUpNothing() {
    Controller attended =
        new Controller(ControllerOptions.headless().withOperator(Operator.present()));
    CompletableFuture<Reply> shown =
        attended.submit(new MessageCommand.ShowPopup("Popup", "hello"));
    attended.advance();
    assertEquals(new Reply.Done(), shown.join());
    Popup popup = attended.state().openPopups().getFirst();
    assertEquals("hello", popup.text());
    assertFalse(popup.blocking());
  }

  @Test
  void shuttingDownEndsTheProgramAndSwitchesTheArmOff() {
    interpreting();
    TestController.ask(controller, new BoxCommand.ShutDown());
    controller.advance();
    assertTrue(controller.state().safety().shutDown());
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }
}
