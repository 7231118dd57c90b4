package org.pendant.protocols;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.eip.EipServer;
import org.pendant.protocols.interpreter.InterpreterServer;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.realtime.RealtimeServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.script.ScriptDesk;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.Server;

/** All ports of a control box. */
public final class BoxPorts implements AutoCloseable {
  /** Opens the ports of one protocol. */
  @FunctionalInterface
  private interface Opening {
    Server open() throws IOException;
  }

  private final List<Server> servers;

  private BoxPorts(List<Server> servers) {
    this.servers = List.copyOf(servers);
  }

  /**
   * Opens all of them, or none.
   *
   * @param panel works the box for the dashboard's clients
   * @throws IOException if a port cannot be had; the message names protocol, address and port
   */
  public static BoxPorts open(Outside outside, PortNumbers numbers, Panel panel)
      throws IOException {
    ScriptDesk desk = new ScriptDesk(outside);
    List<Opening> openings =
        List.of(
            () -> PrimaryServer.open(outside, numbers, desk),
            () -> RealtimeServer.open(outside, numbers, desk),
            () -> RtdeServer.open(outside, numbers),
            () -> DashboardServer.open(outside, numbers, panel),
            () -> InterpreterServer.open(outside, numbers, panel.setup().logs()),
            () -> ModbusServer.open(outside, numbers),
            () -> EipServer.open(outside, numbers));
    List<Server> open = new ArrayList<>();
    try {
      for (Opening each : openings) {
        open.add(each.open());
      }
    } catch (IOException e) {
      open.forEach(Server::close);
      throw e;
    }
    return new BoxPorts(open);
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
