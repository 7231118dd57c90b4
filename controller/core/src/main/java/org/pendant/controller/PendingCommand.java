package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;

/**
 * Command on its way. The client that has left it may take it back as long as no frame has taken
 * it: so it is either carried out or not, never both. Any thread.
 */
public final class PendingCommand {
  static final Reply INTERRUPTED = new Reply.Busy("interrupted");

  private final Command command;
  private final Consumer<PendingCommand> removal;
  private final CompletableFuture<Reply> reply = new CompletableFuture<>();

  /** A frame has taken it, or it was taken back. */
  private final AtomicBoolean decided = new AtomicBoolean();

  /**
   * On its way.
   *
   * @param removal takes it from its queue
   */
  PendingCommand(Command command, Consumer<PendingCommand> removal) {
    this.command = command;
    this.removal = removal;
  }

  Command command() {
    return command;
  }

  /** The answer, at the end of the frame that has carried it out; none once it is taken back. */
  public CompletableFuture<Reply> reply() {
    return reply;
  }

  /** A frame takes it, unless it was taken back. */
  boolean begin() {
    return decided.compareAndSet(false, true);
  }

  /** Takes it back; false when a frame has taken it already. */
  public boolean withdraw() {
    boolean mine = decided.compareAndSet(false, true);
    if (mine) {
      // its place in the queue is for others
      removal.accept(this);
    }
    return mine;
  }

  /**
   * Waits for the answer. A thread that is interrupted meanwhile stays so, and is answered {@link
   * Reply.Busy}.
   *
   * @param spentNs how much of the time has gone by, ns
   */
  Reply await(Deadline deadline, long spentNs) {
    try {
      return reply.get(deadline.afterNs() - spentNs, TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return deadline.late() || withdraw() ? noAnswer() : awaitEndOfFrame(deadline);
    } catch (InterruptedException e) {
      return interrupted(deadline);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A frame is at it, which is not over only if the controller has failed in the middle of it. */
  private Reply awaitEndOfFrame(Deadline deadline) {
    try {
      return reply.get(deadline.afterNs(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return noAnswer();
    } catch (InterruptedException e) {
      return interrupted(deadline);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Reply noAnswer() {
    return new Reply.Busy(text("noAnswer"));
  }

  private Reply interrupted(Deadline deadline) {
    Thread.currentThread().interrupt();
    if (!deadline.late()) {
      withdraw();
    }
    return INTERRUPTED;
  }
}
