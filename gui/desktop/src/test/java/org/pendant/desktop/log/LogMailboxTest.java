package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SharedCell;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

final class LogMailboxTest {
  private static final String THREE_MESSAGES =
      """
      def three():
        textmsg("a")
        sync()
        textmsg("b")
        sync()
        textmsg("c")
      end
      """;

  private static Controller running() {
    Controller controller = new Controller(ControllerOptions.headless());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, THREE_MESSAGES)));
    controller.advance();
    return controller;
  }

  private static void finish(Controller controller, LogMailbox mailbox) {
    for (int i = 0; i < 20; i++) {
      controller.advance();
      mailbox.frame(controller.state());
    }
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }

  /** Of the program alone. */
  private static List<String> texts(LogMailbox mailbox, long since) {
    return mailbox.since(since).stream()
        .filter(line -> line.source() == LogSource.PROGRAM)
        .map(LogLine::text)
        .toList();
  }

  @Test
  void everyMessageArrivesWithThoseFromBeforeTheFirstFrame() {
    Controller controller = running();
    LogMailbox mailbox = new LogMailbox(8, controller::logSince, InstantSource.system());
    finish(controller, mailbox);
    assertEquals(List.of("a", "b", "c"), texts(mailbox, 0));
    assertEquals(List.of("c"), texts(mailbox, 2));
  }

  @Test
  void numbersGoOnWhenAnotherControllerIsSwitchedOn() {
    Controller first = running();
    LogMailbox mailbox = new LogMailbox(8, first::logSince, InstantSource.system());
    finish(first, mailbox);
    Controller second = running();
    mailbox.frame(second.state());
    finish(second, mailbox);
    assertEquals(List.of("a", "b", "c"), texts(mailbox, 4));
    assertEquals(8, mailbox.newest(), "with the two that tell of the ends of the programs");
  }

  @Test
  void aBranchDoesNotSayItsPastAgain() {
    Controller first = running();
    LogMailbox mailbox = new LogMailbox(8, first::logSince, InstantSource.system());
    finish(first, mailbox);
    Controller branch = running();
    branch.advance();
    mailbox.frame(branch.state());
    assertEquals(List.of("b"), texts(mailbox, 3));
    finish(branch, mailbox);
    assertEquals(List.of("b", "c"), texts(mailbox, 3));
  }

  @Test
  void onlyTheNewestAreKept() {
    Controller controller = running();
    LogMailbox mailbox = new LogMailbox(3, controller::logSince, InstantSource.system());
    finish(controller, mailbox);
    assertEquals(List.of("b", "c"), texts(mailbox, 0));
    assertEquals("Program three finished", mailbox.since(3).getFirst().text());
    assertTrue(mailbox.since(4).isEmpty());
  }

  @Test
  void whatTheWindowTellsIsKeptWithItsTime() {
    Controller controller = running();
    Instant now = Instant.parse("2026-01-02T03:04:05Z");
    LogMailbox mailbox = new LogMailbox(8, controller::logSince, InstantSource.fixed(now));
    finish(controller, mailbox);
    mailbox.told("Saved \u00e4");
    LogLine told = mailbox.since(4).getFirst();
    assertEquals("Saved \u00e4", told.text());
    assertEquals(LogSource.WINDOW, told.source());
    assertEquals(controller.state().timeS(), told.timeS());
    assertEquals(now, told.wall());
  }

  @Test
  void messagesOfACellAreOfAllItsControllersAndSayOfWhich() throws Exception {
    LogMailbox mailbox = new LogMailbox(100, number -> List.of(), InstantSource.system());
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.restart(SharedCell.setup());
      session.addCellListener(mailbox);
      for (SessionMember each : session.members()) {
        Program program = TestController.program(each.robot(), "textmsg(\"here\")\n");
        session.run(each, program).get(30, TimeUnit.SECONDS);
      }
      while (texts(mailbox, 0).size() < 3) {
        Thread.onSpinWait();
      }
    }
    assertEquals(
        List.of("cell: here", "left: here", "right: here"),
        texts(mailbox, 0).stream().sorted().toList());
  }
}
