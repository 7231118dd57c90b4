package org.pendant.gui.ports;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.pendant.controller.Command;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.gui.session.Session;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.externalcontrol.Drivers;
import org.pendant.protocols.net.FrameFan;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.panel.PanelSetup;
import org.pendant.protocols.reach.AllowedHosts;
import org.pendant.protocols.serve.MissingPort;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.RemoteControl;

/** The ports of one controller, as long as they are open. */
final class OpenPorts implements AutoCloseable {
  private final FrameFan frames;
  private final BoxPorts box;

  private OpenPorts(FrameFan frames, BoxPorts box) {
    this.frames = frames;
    this.box = box;
  }

  /**
   * Opens the ports of the session's present controller, as far as they can be had.
   *
   * @param shutDown runs once when the controller shuts itself down, in a thread that must not wait
   */
  static OpenPorts open(
      Session session,
      PortNumbers numbers,
      RemoteControl remote,
      ProgramsFolder programs,
      Path logs,
      Runnable shutDown) {
    PeerLog log =
        new PeerLog(
            (level, text) -> {
              // a line that finds no place among the commands of a frame is lost
              var _ = session.submit(new Command.WriteLog(level, text));
            });
    FrameFan frames = new FrameFan(session.controller().feed(), log);
    Outside outside = new Outside(session.controller(), frames, log, remote);
    Panel panel =
        new Panel(
            session.controller(),
            new PanelSetup(
                session.options().robotId(),
                programs,
                logs,
                new Drivers(AllowedHosts.ANY, Optional.empty())));
    BoxPorts box = BoxPorts.open(outside, numbers, panel, session.toolSerial());
    var _ = session.submit(new Command.SetProgramsFolder(programs));
    AtomicBoolean told = new AtomicBoolean();
    frames.add(
        state -> {
          if (state.safety().shutDown() && !told.getAndSet(true)) {
            shutDown.run();
          }
        });
    return new OpenPorts(frames, box);
  }

  /** The ports, in the order of the real box's documentation. */
  List<TcpPort> ports() {
    return box.ports();
  }

  /** What could not be had. */
  List<MissingPort> missing() {
    return box.missing();
  }

  @Override
  public void close() {
    box.close();
    frames.close();
  }
}
