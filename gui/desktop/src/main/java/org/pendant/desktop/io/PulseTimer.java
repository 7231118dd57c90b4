package org.pendant.desktop.io;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.FrameListener;

/**
 * Pulse timer: ends pulses on inputs when their time has come, to the frame, whether their screen
 * is shown or not. Any thread begins pulses; the frame loop ends them.
 */
final class PulseTimer implements FrameListener {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Map<Signal, Pulse> running = new ConcurrentHashMap<>();
  private double timeS;

  /**
   * A level that ends by itself.
   *
   * @param level during the pulse
   * @param endS controller time when it ends, s; not a number until it has begun
   */
  private record Pulse(boolean level, double lengthS, double endS) {}

  /** A timer that sets inputs through {@code submit}. */
  PulseTimer(Function<Command, CompletableFuture<Reply>> submit) {
    this.submit = submit;
  }

  /**
   * Begins a pulse; the time counts from the frame that sets the input.
   *
   * @param level during the pulse
   * @return the reply to the start
   */
  CompletableFuture<Reply> begin(Signal input, boolean level, PulseLength length) {
    running.put(input, new Pulse(level, length.seconds(), Double.NaN));
    return submit.apply(new IoCommand.SetInput(input.toString(), level));
  }

  /** Forgets a pulse; the level stays. */
  void cancel(Signal input) {
    running.remove(input);
  }

  /** Forgets all pulses, and leaves their inputs low. */
  void cancelAll() {
    for (Signal input : running.keySet()) {
      cancel(input);
      var _ = submit.apply(new IoCommand.SetInput(input.toString(), false));
    }
  }

  boolean running(Signal input) {
    return running.containsKey(input);
  }

  @Override
  public void frame(ControllerState state) {
    if (state.timeS() < timeS) {
      // another controller has been switched on
      running.clear();
    }
    timeS = state.timeS();
    if (!running.isEmpty()) {
      running.forEach((input, pulse) -> step(input, pulse, state));
    }
  }

  private void step(Signal input, Pulse pulse, ControllerState state) {
    boolean high = (state.io().bits(input.bank()) >> input.index() & 1) != 0;
    if (Double.isNaN(pulse.endS())) {
      if (high == pulse.level()) {
        Pulse begun = new Pulse(pulse.level(), pulse.lengthS(), timeS + pulse.lengthS());
        running.replace(input, pulse, begun);
      }
    } else if (timeS >= pulse.endS() && running.remove(input, pulse)) {
      var _ = submit.apply(new IoCommand.SetInput(input.toString(), !pulse.level()));
    }
  }
}
