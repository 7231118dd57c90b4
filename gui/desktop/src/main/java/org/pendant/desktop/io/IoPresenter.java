package org.pendant.desktop.io;

import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * I/O presenter: what the screen of signals shows and does. One thread uses it, the one behind its
 * executor.
 */
final class IoPresenter {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private final Consumer<String> notify;
  private final Forcing forcing;
  private final PulseTimer pulses;
  private final Map<SafetyInput, Boolean> safety = new EnumMap<>(SafetyInput.class);
  private DigitalLevels levels = DigitalLevels.ALL_LOW;
  private PulseLength pulseLength = PulseLength.STANDARD;
  private long frame = -1;
  private boolean programRuns;

  /**
   * A screen that has seen nothing.
   *
   * @param submit hands commands to the controller
   * @param pulses ends pulses
   * @param executor runs what replies lead to in the thread that uses this object
   * @param notify tells people why something was refused
   */
  IoPresenter(
      Function<Command, CompletableFuture<Reply>> submit,
      PulseTimer pulses,
      Executor executor,
      Consumer<String> notify) {
    this.submit = submit;
    this.pulses = pulses;
    this.executor = executor;
    this.notify = notify;
    forcing = new Forcing(submit, executor, notify);
  }

  /** Takes the newest snapshot. */
  void take(ControllerState state) {
    if (state.frame() < frame) {
      // another controller has been switched on
      forcing.forget();
      safety.clear();
    }
    boolean first = frame < 0 || state.frame() < frame;
    frame = state.frame();
    levels = state.io();
    programRuns = state.program().state() != ProgramState.STOPPED;
    if (first) {
      guessSafety(state);
    }
  }

  /** Snapshots tell what safety inputs cause, not which are active: a guess to begin with. */
  private void guessSafety(ControllerState state) {
    SafetyMode mode = state.safety().safetyMode();
    safety.put(SafetyInput.EMERGENCY_STOP, mode == SafetyMode.ROBOT_EMERGENCY_STOP);
    safety.put(SafetyInput.SYSTEM_EMERGENCY_STOP, mode == SafetyMode.SYSTEM_EMERGENCY_STOP);
    safety.put(SafetyInput.SAFEGUARD_STOP, mode == SafetyMode.SAFEGUARD_STOP);
    safety.put(
        SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP,
        mode == SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP);
    safety.put(SafetyInput.REDUCED_MODE, state.safety().reduced());
  }

  private boolean snapshotLevel(Signal signal) {
    return (levels.bits(signal.bank()) >> signal.index() & 1) != 0;
  }

  /** The level of a signal; one that was asked for counts before the controller has set it. */
  boolean level(Signal signal) {
    return forcing
        .asked(SignalWrite.Digital.class, signal.toString())
        .map(SignalWrite.Digital::level)
        .orElseGet(() -> snapshotLevel(signal));
  }

  /** Whether people may change the level now: of outputs and flags while no program runs. */
  boolean settable(Signal signal) {
    return signal.bank().input() || !programRuns;
  }

  /** Changes the level of a signal; a pulse of it ends. */
  void toggle(Signal signal) {
    if (settable(signal)) {
      pulses.cancel(signal);
      forcing.write(new SignalWrite.Digital(signal, !level(signal)));
    }
  }

  /** Signals that people set by hand. */
  Forcing forcing() {
    return forcing;
  }

  /** Brings all forced inputs to rest; pulses end. */
  void releaseAll() {
    pulses.cancelAll();
    forcing.releaseAll();
  }

  /** Changes the level of an input for the length of a pulse. */
  void pulse(Signal input) {
    if (!pulsing(input)) {
      boolean level = !level(input);
      forcing.show(new SignalWrite.Digital(input, level), pulses.begin(input, level, pulseLength));
    }
  }

  /** Whether a pulse of this input is under way. */
  boolean pulsing(Signal input) {
    return pulses.running(input);
  }

  /** Pulses that begin from now on have this length. */
  void setPulseLength(PulseLength length) {
    pulseLength = length;
  }

  /** Whether a safety input demands its function, as far as it was set here. */
  boolean active(SafetyInput input) {
    return safety.getOrDefault(input, false);
  }

  /** Demands a safety function, or no longer does. */
  void toggle(SafetyInput input) {
    boolean before = active(input);
    safety.put(input, !before);
    var _ =
        submit
            .apply(new SafetyCommand.SetSafetyInput(input, !before))
            .thenAcceptAsync(
                reply -> {
                  if (reply.complaint().isPresent()) {
                    safety.put(input, before);
                  }
                  tell(reply);
                },
                executor);
  }

  private void tell(Reply reply) {
    reply.complaint().ifPresent(notify);
  }
}
