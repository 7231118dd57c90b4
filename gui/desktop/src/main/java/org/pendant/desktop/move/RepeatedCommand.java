package org.pendant.desktop.move;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;

/**
 * Repeated command: one that applies only as long as it is repeated: sends it again and again until
 * it is let go or refused. A reply that is due is waited for, so that a slow controller is not
 * flooded. One thread uses it, the one behind its executor.
 */
final class RepeatedCommand {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private final Command end;
  private Optional<Hold> hold = Optional.empty();
  private String reason = "";

  /** One hold, until it is let go. */
  private static final class Hold {
    Command command;
    boolean waiting;
    boolean refused;

    Hold(Command command) {
      this.command = command;
    }
  }

  /**
   * Nothing is held.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   * @param end the command that ends what is held
   */
  RepeatedCommand(
      Function<Command, CompletableFuture<Reply>> submit, Executor executor, Command end) {
    this.submit = submit;
    this.executor = executor;
    this.end = end;
  }

  /** Holds this from now on. */
  void begin(Command command) {
    reason = "";
    hold = Optional.of(new Hold(command));
    repeat();
  }

  /** What is held has changed; sent when it is repeated. */
  void change(Command command) {
    hold.ifPresent(present -> present.command = command);
  }

  /** Time goes by: about 30 times a second. */
  void repeat() {
    if (hold.isPresent() && !hold.get().waiting && !hold.get().refused) {
      Hold present = hold.get();
      present.waiting = true;
      var _ =
          submit
              .apply(present.command)
              .thenAcceptAsync(reply -> answered(present, reply), executor);
    }
  }

  private void answered(Hold of, Reply reply) {
    of.waiting = false;
    Optional<String> why = reply.complaint();
    if (why.isPresent() && hold.isPresent() && hold.get() == of) {
      of.refused = true;
      reason = why.get();
    }
  }

  /** Lets go. */
  void release() {
    if (hold.isPresent()) {
      hold = Optional.empty();
      var _ = submit.apply(end);
    }
  }

  boolean held() {
    return hold.isPresent();
  }

  /** Whether the controller has refused what is held. */
  boolean refused() {
    return hold.isPresent() && hold.get().refused;
  }

  /** Why what was held last has been refused; empty if it was not. */
  String reason() {
    return reason;
  }
}
