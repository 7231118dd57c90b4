package org.pendant.controller;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/**
 * A command on its way. Whoever has left it may take it back as long as no frame has taken it: so
 * it is either carried out or refused, never both. Any thread.
 */
public final class PendingCommand {
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
   * Waits for the answer; a command that no frame has taken by then is taken back and refused.
   *
   * @param patience a frame takes 2 ms: who gets no answer for much longer speaks to a box whose
   *     time stands still
   */
  public Reply await(Duration patience) throws InterruptedException {
    try {
      return reply.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return withdraw() ? noAnswer() : awaitEndOfFrame(patience);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A frame is at it, which is not over only if the controller has failed in the middle of it. */
  private Reply awaitEndOfFrame(Duration patience) throws InterruptedException {
    try {
      return reply.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return noAnswer();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Reply noAnswer() {
    return new Reply.Refused("the controller does not answer");
  }
}
