package org.pendant.protocols;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.device.DeviceState;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.device.DeviceServer;
import org.pendant.protocols.device.ProcedureServer;
import org.pendant.protocols.eip.EipServer;
import org.pendant.protocols.interpreter.InterpreterServer;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.realtime.RealtimeServer;
import org.pendant.protocols.robotapi.RobotApiServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.PortOpening;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.protocols.toolserial.ToolSerialServer;

/** Ports of a control box, all of them. */
public final class BoxPorts implements AutoCloseable {
  private final List<Server> servers = new ArrayList<>();
  private final PortOpening opening = new PortOpening();

  private BoxPorts() {}

  /** Opens a server. */
  @FunctionalInterface
  private interface Opening {
    Server open() throws IOException;
  }

  /**
   * Opens all ports that can be had; {@link #missing} says which cannot. There is a Robot API where
   * a port is chosen for it: boxes with PolyScope 5 have none.
   *
   * @param remotePendant works the box for the dashboard's clients
   */
  public static BoxPorts open(
      ServerContext serverContext, PortNumbers numbers, RemotePendant remotePendant) {
    ScriptHandler scriptHandler = new ScriptHandler(serverContext);
    BoxPorts ports = new BoxPorts();
    ports.add(PrimaryServer.open(serverContext, numbers, scriptHandler));
    ports.add(RealtimeServer.open(serverContext, numbers, scriptHandler));
    ports.open(RtdeServer.STANDARD_PORT, () -> RtdeServer.open(serverContext, numbers));
    ports.open(
        DashboardServer.STANDARD_PORT,
        () -> DashboardServer.open(serverContext, numbers, remotePendant));
    ports.open(
        InterpreterServer.STANDARD_PORT,
        () -> InterpreterServer.open(serverContext, numbers, remotePendant.setup().logs()));
    ports.open(ModbusServer.STANDARD_PORT, () -> ModbusServer.open(serverContext, numbers));
    ports.open(EipServer.STANDARD_PORT, () -> EipServer.open(serverContext, numbers));
    if (numbers.chosen().containsKey(RobotApiServer.STANDARD_PORT)) {
      ports.open(
          RobotApiServer.STANDARD_PORT,
          () -> RobotApiServer.open(serverContext, numbers, remotePendant));
    }
    for (DeviceState device : DeviceServer.wanted(serverContext)) {
      ports.open(device.port(), () -> DeviceServer.open(serverContext, numbers, device));
    }
    for (int port : ProcedureServer.wanted(serverContext)) {
      ports.open(port, () -> ProcedureServer.open(serverContext, numbers, port));
    }
    ports.needFramesOf(serverContext.frames());
    return ports;
  }

  /**
   * As {@link #open(ServerContext, PortNumbers, RemotePendant)}, with the port of the tool's serial
   * line.
   */
  public static BoxPorts open(
      ServerContext serverContext,
      PortNumbers numbers,
      RemotePendant remotePendant,
      ToolSerialLine line) {
    BoxPorts ports = open(serverContext, numbers, remotePendant);
    ports.open(
        ToolSerialServer.STANDARD_PORT,
        () -> ToolSerialServer.open(line, numbers, serverContext.log()));
    ports.needFramesOf(serverContext.frames());
    return ports;
  }

  /** Frames must come on time while somebody is connected. */
  private void needFramesOf(StateBroadcaster frames) {
    List<TcpPort> all = ports();
    all.forEach(each -> each.whenConnected(frames::peerCame));
    frames.onTimeWhile(() -> all.stream().anyMatch(TcpPort::connected));
  }

  private void open(int standardPort, Opening server) {
    opening.attempt(standardPort, () -> add(server.open()));
  }

  private void add(Server server) {
    servers.add(server);
  }

  /** What could not be had, such as a port that another program has. */
  public List<MissingPort> missing() {
    return Stream.concat(
            servers.stream().flatMap(each -> each.missing().stream()), opening.missing().stream())
        .toList();
  }

  /** The ports, in the order of the real box's documentation. */
  public List<TcpPort> ports() {
    return servers.stream().flatMap(each -> each.ports().stream()).toList();
  }

  /**
   * Has {@code listener} hear from now on what goes over all connections of all ports; empty for
   * nobody.
   */
  public void tap(Optional<WireTap> listener) {
    ports().forEach(each -> each.tap(listener));
  }

  @Override
  public void close() {
    servers.forEach(Server::close);
  }
}
