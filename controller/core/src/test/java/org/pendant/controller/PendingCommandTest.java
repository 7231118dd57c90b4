package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;

class PendingCommandTest {
  private static final Command SLOWER = new BoxCommand.SetSpeedFraction("client", 0.5);

  private final Controller controller = new Controller(ControllerOptions.headless());

  private double speedFraction() {
    return controller.state().arm().speedFraction();
  }

  @Test
  void whatIsTakenBackIsNotCarriedOut() {
    PendingCommand slower = controller.post(SLOWER);
    assertTrue(slower.withdraw());
    controller.advance();
    assertEquals(1.0, speedFraction());
    assertFalse(slower.reply().isDone());
  }

  @Test
  void whatAFrameHasTakenCannotBeTakenBack() {
    PendingCommand slower = controller.post(SLOWER);
    controller.advance();
    assertFalse(slower.withdraw());
    assertEquals(0.5, speedFraction());
    assertEquals(new Reply.Done(), slower.reply().join());
  }

  @Test
  void whatIsRefusedForWantOfAnAnswerIsNotCarriedOutLater() throws Exception {
    PendingCommand slower = controller.post(SLOWER);
    assertEquals(
        new Reply.Busy("the controller does not answer"),
        slower.await(Deadline.orNever(Duration.ofMillis(1)), 0));
    controller.advance();
    assertEquals(1.0, speedFraction());
  }

  @Test
  void whatIsTakenBackLeavesItsPlaceToOthers() {
    for (int i = 0; i < 5 * CommandQueue.CAPACITY; i++) {
      assertTrue(controller.post(SLOWER).withdraw());
    }
    PendingCommand last = controller.post(SLOWER);
    controller.advance();
    assertEquals(new Reply.Done(), last.reply().join());
  }

  @Test
  void moreThanAFrameTakesIsRefusedAtOnce() {
    for (int i = 0; i < CommandQueue.CAPACITY; i++) {
      controller.post(SLOWER);
    }
    assertInstanceOf(Reply.Busy.class, controller.post(SLOWER).reply().getNow(null));
  }
}
