package org.pendant.protocols;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.eip.EipServer;
import org.pendant.protocols.interpreter.InterpreterServer;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.realtime.RealtimeServer;
import org.pendant.protocols.robotapi.RobotApiServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.script.ScriptDesk;
import org.pendant.protocols.serve.MissingPort;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.PortOpening;
import org.pendant.protocols.serve.Server;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.protocols.toolserial.ToolSerialServer;

/** All ports of a control box. */
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
   * @param panel works the box for the dashboard's clients
   */
  public static BoxPorts open(Outside outside, PortNumbers numbers, Panel panel) {
    ScriptDesk desk = new ScriptDesk(outside);
    BoxPorts ports = new BoxPorts();
    ports.add(PrimaryServer.open(outside, numbers, desk));
    ports.add(RealtimeServer.open(outside, numbers, desk));
    ports.open(RtdeServer.STANDARD_PORT, () -> RtdeServer.open(outside, numbers));
    ports.open(DashboardServer.STANDARD_PORT, () -> DashboardServer.open(outside, numbers, panel));
    ports.open(
        InterpreterServer.STANDARD_PORT,
        () -> InterpreterServer.open(outside, numbers, panel.setup().logs()));
    ports.open(ModbusServer.STANDARD_PORT, () -> ModbusServer.open(outside, numbers));
    ports.open(EipServer.STANDARD_PORT, () -> EipServer.open(outside, numbers));
    if (numbers.chosen().containsKey(RobotApiServer.STANDARD_PORT)) {
      ports.open(RobotApiServer.STANDARD_PORT, () -> RobotApiServer.open(outside, numbers, panel));
    }
    return ports;
  }

  /** As {@link #open(Outside, PortNumbers, Panel)}, with the port of the tool's serial line. */
  public static BoxPorts open(
      Outside outside, PortNumbers numbers, Panel panel, ToolSerialLine line) {
    BoxPorts ports = open(outside, numbers, panel);
    ports.open(
        ToolSerialServer.STANDARD_PORT, () -> ToolSerialServer.open(line, numbers, outside.log()));
    return ports;
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

  @Override
  public void close() {
    servers.forEach(Server::close);
  }
}
