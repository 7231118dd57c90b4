package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.SafetyCommand;

final class RepeatedCommandTest {
  private static final Command FIRST = new SafetyCommand.PowerOn();
  private static final Command SECOND = new SafetyCommand.PowerOff();
  private static final Command END = new WorldCommand.LetGo();

  private final List<Command> sent = new ArrayList<>();
  private final List<CompletableFuture<Reply>> replies = new ArrayList<>();
  private final RepeatedCommand repeated = new RepeatedCommand(this::submit, Runnable::run, END);

  private CompletableFuture<Reply> submit(Command command) {
    sent.add(command);
    replies.add(new CompletableFuture<>());
    return replies.getLast();
  }

  private void answer(Reply reply) {
    replies.getLast().complete(reply);
  }

  @Test
  void isSentAtOnceAndAgainOnceItIsAnswered() {
    repeated.begin(FIRST);
    repeated.repeat();
    assertEquals(List.of(FIRST), sent, "not before the reply");
    answer(new Reply.Done());
    repeated.repeat();
    assertEquals(List.of(FIRST, FIRST), sent);
  }

  @Test
  void aChangeIsSentNextTime() {
    repeated.begin(FIRST);
    repeated.change(SECOND);
    answer(new Reply.Done());
    repeated.repeat();
    assertEquals(List.of(FIRST, SECOND), sent);
  }

  @Test
  void afterARefusalNothingIsRepeatedAndTheReasonStays() {
    repeated.begin(FIRST);
    answer(new Reply.Refused(Refusal.Code.INVALID, "no"));
    repeated.repeat();
    assertTrue(repeated.refused());
    repeated.release();
    assertFalse(repeated.refused());
    assertEquals("no", repeated.reason());
    assertEquals(List.of(FIRST, END), sent);
    repeated.begin(SECOND);
    assertEquals("", repeated.reason());
  }

  @Test
  void theAnswerToAnEarlierHoldSaysNothingOfThisOne() {
    repeated.begin(FIRST);
    CompletableFuture<Reply> old = replies.getLast();
    repeated.release();
    repeated.begin(SECOND);
    old.complete(new Reply.Refused(Refusal.Code.INVALID, "too late"));
    assertFalse(repeated.refused());
  }

  @Test
  void letGoOnceIsEnough() {
    repeated.release();
    repeated.begin(FIRST);
    repeated.release();
    repeated.release();
    repeated.repeat();
    repeated.change(SECOND);
    assertEquals(List.of(FIRST, END), sent);
  }
}
