package org.pendant.desktop.waveform;

import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.desktop.session.SwitchListener;

/** Waveform player: has the session's controller play waveforms, whichever that is. */
final class WaveformPlayer implements SwitchListener {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private volatile InputWaveforms wanted = InputWaveforms.NONE;

  WaveformPlayer(Function<Command, CompletableFuture<Reply>> submit) {
    this.submit = submit;
  }

  /** Plays these from the next start of a program on; {@link InputWaveforms#NONE} for none. */
  void play(InputWaveforms waveforms) {
    if (!waveforms.equals(wanted)) {
      wanted = waveforms;
      send();
    }
  }

  private void send() {
    var _ = submit.apply(new IoCommand.PlayInputs(wanted));
  }

  @Override
  public void switchingOff() {}

  @Override
  public void switchedOn() {
    if (!wanted.equals(InputWaveforms.NONE)) {
      send();
    }
  }
}
