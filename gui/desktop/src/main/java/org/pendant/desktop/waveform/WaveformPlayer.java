package org.pendant.desktop.waveform;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SwitchListener;

/**
 * Waveform player: has each of the session's controllers play waveforms of its own, also when
 * another one takes its place. Those that are lent are not for what people have drawn.
 */
final class WaveformPlayer implements SwitchListener {
  private final RobotSession session;

  /** By the name of the controller. */
  private final Map<String, InputWaveforms> wanted = new ConcurrentHashMap<>();

  WaveformPlayer(RobotSession session) {
    this.session = session;
  }

  /**
   * Plays these from the next start of a program on; {@link InputWaveforms#NONE} for none.
   *
   * @param controller its name; it need not be there yet
   */
  void play(String controller, InputWaveforms waveforms) {
    InputWaveforms before = wanted.put(controller, waveforms);
    if (!waveforms.equals(before == null ? InputWaveforms.NONE : before)) {
      session.members().stream()
          .filter(each -> each.name().equals(controller))
          .forEach(each -> send(each, waveforms));
    }
  }

  private void send(SessionMember member, InputWaveforms waveforms) {
    if (!session.lent()) {
      var _ = session.submit(member, new IoCommand.PlayInputs(waveforms));
    }
  }

  @Override
  public void switchingOff() {}

  @Override
  public void switchedOn() {
    for (SessionMember each : session.members()) {
      InputWaveforms own = wanted.getOrDefault(each.name(), InputWaveforms.NONE);
      if (!own.equals(InputWaveforms.NONE)) {
        send(each, own);
      }
    }
  }
}
