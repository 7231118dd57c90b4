package org.pendant.desktop.move;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.jog.JogMove;

/**
 * Jog hold: a button that moves the arm while it is held: tells the controller so again and again
 * until it is let go, or the controller says that the arm goes no further. One thread uses it, the
 * one behind its executor.
 */
public final class JogHold {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private Optional<Press> press = Optional.empty();
  private String reason = "";

  /** One press on a button, until it is let go. */
  private static final class Press {
    final ManualCommand.Jog command;
    boolean waiting;
    boolean answered;
    boolean refused;

    Press(ManualCommand.Jog command) {
      this.command = command;
    }
  }

  /**
   * Nothing is held.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   */
  public JogHold(Function<Command, CompletableFuture<Reply>> submit, Executor executor) {
    this.submit = submit;
    this.executor = executor;
  }

  /** A button is pressed; the same one again, as keys that repeat do, changes nothing. */
  public void press(JogMove move, double speedFraction) {
    if (press.isPresent() && press.get().command.move().equals(move)) {
      return;
    }
    release();
    reason = "";
    press = Optional.of(new Press(new ManualCommand.Jog(move, speedFraction)));
    repeat();
  }

  /** Time goes by: about 30 times a second. A reply that is due is waited for. */
  public void repeat() {
    if (press.isPresent() && !press.get().waiting && !press.get().refused) {
      Press present = press.get();
      present.waiting = true;
      var _ =
          submit
              .apply(present.command)
              .thenAcceptAsync(reply -> answered(present, reply), executor);
    }
  }

  private void answered(Press of, Reply reply) {
    of.waiting = false;
    of.answered = true;
    Optional<String> why = reply.complaint();
    if (why.isPresent() && press.isPresent() && press.get() == of) {
      of.refused = true;
      reason = why.get();
    }
  }

  /** The button is let go. */
  public void release() {
    if (press.isPresent()) {
      press = Optional.empty();
      var _ = submit.apply(new ManualCommand.StopJog());
    }
  }

  /** Whether the controller has answered to what is held; true also when nothing is. */
  boolean settled() {
    return press.isEmpty() || press.get().answered;
  }

  /** Whether the controller has said that the arm goes no further. */
  boolean refused() {
    return press.isPresent() && press.get().refused;
  }

  /** What is held, whether the arm goes any further or not. */
  Optional<JogMove> held() {
    return press.map(present -> present.command.move());
  }

  /** Why the arm did not do what was held last, or not any further; empty if it did. */
  public String reason() {
    return reason;
  }
}
