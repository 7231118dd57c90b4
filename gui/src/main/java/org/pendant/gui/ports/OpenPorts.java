package org.pendant.gui.ports;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.pendant.controller.Command;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.gui.session.Session;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.net.FrameFan;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.panel.PanelSetup;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.RemoteControl;
import org.pendant.protocols.toolserial.ToolSerialServer;

/** The ports of one controller, as long as they are open. */
final class OpenPorts implements AutoCloseable {
  private final FrameFan frames;
  private final BoxPorts box;
  private final ToolSerialServer serial;

  private OpenPorts(FrameFan frames, BoxPorts box, ToolSerialServer serial) {
    this.frames = frames;
    this.box = box;
    this.serial = serial;
  }

  /**
   * Opens all ports of the session's present controller, or none.
   *
   * @param shutDown runs once when the controller shuts itself down, in a thread that must not wait
   * @throws IOException if a port cannot be had; the message names protocol, address and port
   */
  static OpenPorts open(
      Session session,
      PortNumbers numbers,
      RemoteControl remote,
      ProgramsFolder programs,
      Path logs,
      Runnable shutDown)
      throws IOException {
    PeerLog log =
        new PeerLog(
            (level, text) -> {
              // a line that finds no place among the commands of a frame is lost
              var _ = session.submit(new Command.WriteLog(level, text));
            });
    FrameFan frames = new FrameFan(session.controller().feed(), log);
    try {
      Outside outside = new Outside(session.controller(), frames, log, remote);
      Panel panel =
          new Panel(
              session.controller(), new PanelSetup(session.options().robotId(), programs, logs));
      BoxPorts box = BoxPorts.open(outside, numbers, panel);
      OpenPorts open = new OpenPorts(frames, box, serial(session, numbers, log, box));
      var _ = session.submit(new Command.SetProgramsFolder(programs));
      AtomicBoolean told = new AtomicBoolean();
      frames.add(
          state -> {
            if (state.safety().shutDown() && !told.getAndSet(true)) {
              shutDown.run();
            }
          });
      return open;
    } catch (IOException e) {
      frames.close();
      throw e;
    }
  }

  private static ToolSerialServer serial(
      Session session, PortNumbers numbers, PeerLog log, BoxPorts box) throws IOException {
    try {
      return ToolSerialServer.open(session.toolSerial(), numbers, log);
    } catch (IOException e) {
      box.close();
      throw e;
    }
  }

  /** The ports, in the order of the real box's documentation. */
  List<TcpPort> ports() {
    return Stream.concat(box.ports().stream(), serial.ports().stream()).toList();
  }

  @Override
  public void close() {
    serial.close();
    box.close();
    frames.close();
  }
}
