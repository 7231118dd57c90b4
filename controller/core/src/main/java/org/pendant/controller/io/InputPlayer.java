package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.controller.command.Refusal;

/**
 * Input player: plays {@link InputWaveforms} from the start of each program until it ends. Time
 * continues while a program is paused, as it does outside. The frame loop owns it.
 */
public final class InputPlayer {
  /** Under which name it writes signals. */
  static final String WRITER = "waveforms";

  private final Signals signals;
  private final Set<String> refused = new HashSet<>();
  private InputWaveforms waveforms = InputWaveforms.NONE;
  private boolean playing;
  private long frame;
  private int next;

  InputPlayer(Signals signals) {
    this.signals = signals;
  }

  /** Plays these from now on: while a program runs, what is still to come of them. */
  public void set(InputWaveforms wanted) {
    waveforms = wanted;
    frame %= wanted.periodFrames();
    next = 0;
    while (next < wanted.steps() && wanted.frame(next) < frame) {
      next++;
    }
  }

  /** A program begins with the frame that has begun. */
  public void programStarted() {
    playing = true;
    frame = 0;
    next = 0;
    refused.clear();
  }

  /** No program runs any more; inputs stay as they are. */
  public void programEnded() {
    playing = false;
  }

  /**
   * Makes the changes of a frame, before its scripts run.
   *
   * @param warn is told, once a program, of a signal that a client has taken
   */
  public void step(Consumer<String> warn) {
    if (!playing) {
      return;
    }
    if (frame == waveforms.periodFrames()) {
      frame = 0;
      next = 0;
    }
    if (next < waveforms.steps() && waveforms.frame(next) == frame) {
      write(waveforms.writes(next), warn);
      next++;
    }
    frame++;
  }

  private void write(List<SignalWrite> writes, Consumer<String> warn) {
    for (SignalWrite write : writes) {
      Optional<Refusal> refusal = signals.owners().refusal(write.name(), WRITER);
      if (refusal.isEmpty()) {
        signals.write(write);
      } else if (refused.add(write.name())) {
        warn.accept(text("inputWaveform", refusal.get().text()));
      }
    }
  }
}
