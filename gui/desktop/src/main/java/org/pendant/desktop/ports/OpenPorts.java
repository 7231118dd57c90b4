package org.pendant.desktop.ports;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.desktop.session.SessionMember;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.externalcontrol.Drivers;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;

/** Open ports: the ports of one controller, as long as they are open. */
final class OpenPorts implements AutoCloseable {
  private final StateBroadcaster frames;
  private final BoxPorts box;

  private OpenPorts(StateBroadcaster frames, BoxPorts box) {
    this.frames = frames;
    this.box = box;
  }

  /**
   * Opens the ports of a controller, as far as they can be had.
   *
   * @param visits takes which client has come or left; any thread
   * @param shutDown runs once when the controller shuts itself down, in a thread that must not wait
   */
  static OpenPorts open(
      SessionMember member,
      PortNumbers numbers,
      RemoteControl remote,
      ProgramsFolder programs,
      Path logs,
      Consumer<String> visits,
      Runnable shutDown) {
    PeerLog log =
        new PeerLog(
            (level, text) -> {
              // a line that finds no place among the commands of a frame is lost
              var _ = member.submit(new MessageCommand.WriteLog(level, text));
            },
            visits);
    StateBroadcaster frames = new StateBroadcaster(member.robot().feed(), log);
    ServerContext serverContext = new ServerContext(member.robot(), frames, log, remote);
    RemotePendant remotePendant =
        new RemotePendant(
            member.robot(),
            new PendantSetup(
                member.options().robotId(),
                programs,
                logs,
                new Drivers(AllowedHosts.ANY, Optional.empty())));
    BoxPorts box = BoxPorts.open(serverContext, numbers, remotePendant, member.toolSerial());
    var _ = member.submit(new ProgramCommand.SetProgramsFolder(programs));
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

  /** Has {@code listener} hear what goes over all connections; empty for nobody. */
  void tap(Optional<WireTap> listener) {
    box.tap(listener);
  }

  @Override
  public void close() {
    box.close();
    frames.close();
  }
}
