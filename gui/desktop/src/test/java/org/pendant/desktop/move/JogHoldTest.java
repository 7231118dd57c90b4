package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.jog.JogMove;

/** What a held button sends, and when it stops. */
final class JogHoldTest {
  private static final JogMove UP = new JogMove.TurnJoint(0, 1);
  private static final JogMove DOWN = new JogMove.TurnJoint(0, -1);
  private static final Command JOG_UP = new ManualCommand.Jog(UP, 0.5);
  private static final Command STOP = new ManualCommand.StopJog();

  private final List<Command> sent = new ArrayList<>();
  private final List<CompletableFuture<Reply>> replies = new ArrayList<>();
  private final JogHold hold = new JogHold(this::submit, Runnable::run);

  private CompletableFuture<Reply> submit(Command command) {
    sent.add(command);
    replies.add(new CompletableFuture<>());
    return replies.getLast();
  }

  private void answer(Reply reply) {
    replies.getLast().complete(reply);
  }

  @Test
  void aPressSendsAtOnceAndRepeatsUntilTheRelease() {
    hold.press(UP, 0.5);
    answer(new Reply.Done());
    hold.repeat();
    answer(new Reply.Done());
    hold.repeat();
    hold.release();
    hold.repeat();
    assertEquals(List.of(JOG_UP, JOG_UP, JOG_UP, STOP), sent);
    assertEquals(Optional.empty(), hold.held());
  }

  @Test
  void aControllerThatDoesNotAnswerIsNotFloodedWithCommands() {
    hold.press(UP, 0.5);
    hold.repeat();
    hold.repeat();
    assertEquals(List.of(JOG_UP), sent);
    answer(new Reply.Done());
    hold.repeat();
    assertEquals(2, sent.size());
  }

  @Test
  void keysThatRepeatArePressedOnce() {
    hold.press(UP, 0.5);
    hold.press(UP, 0.5);
    hold.press(UP, 0.5);
    assertEquals(List.of(JOG_UP), sent);
  }

  @Test
  void afterARefusalNothingIsRepeatedUntilTheNextPress() {
    hold.press(UP, 0.5);
    answer(new Reply.Refused(Refusal.Code.ARM_RANGE, "joint 0 is at the end of its range"));
    hold.repeat();
    hold.press(UP, 0.5);
    assertEquals(List.of(JOG_UP), sent);
    assertEquals("joint 0 is at the end of its range", hold.reason());
    hold.release();
    assertEquals("joint 0 is at the end of its range", hold.reason(), "to be read in peace");
    hold.press(DOWN, 0.5);
    assertEquals("", hold.reason());
    assertEquals(List.of(JOG_UP, STOP, new ManualCommand.Jog(DOWN, 0.5)), sent);
  }

  @Test
  void anotherButtonReplacesTheFirst() {
    hold.press(UP, 0.5);
    hold.press(DOWN, 0.5);
    assertEquals(Optional.of(DOWN), hold.held());
    assertEquals(List.of(JOG_UP, STOP, new ManualCommand.Jog(DOWN, 0.5)), sent);
  }

  @Test
  void anAnswerToAnOldPressSaysNothingAboutTheNewOne() {
    hold.press(UP, 0.5);
    CompletableFuture<Reply> old = replies.getFirst();
    hold.press(DOWN, 0.5);
    old.complete(new Reply.Refused(Refusal.Code.INVALID, "too late"));
    assertEquals("", hold.reason());
  }

  @Test
  void aReleaseWithoutAPressSendsNothing() {
    hold.release();
    hold.repeat();
    assertEquals(List.of(), sent);
  }
}
