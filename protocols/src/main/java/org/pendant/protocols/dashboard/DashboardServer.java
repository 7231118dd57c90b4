package org.pendant.protocols.dashboard;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.protocols.wire.LineDissector;

/** The dashboard server of a control box. */
public final class DashboardServer implements Server {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 29_999;

  private final TcpPort port;

  private DashboardServer(TcpPort port) {
    this.port = port;
  }

  /**
   * Begins to listen.
   *
   * @param remotePendant works the box for the clients
   * @throws IOException if the port cannot be had
   */
  public static DashboardServer open(
      ServerContext serverContext, PortNumbers numbers, RemotePendant remotePendant)
      throws IOException {
    DashboardHandler dashboardHandler =
        new DashboardHandler(remotePendant, serverContext.remote(), serverContext.log());
    TcpPort port =
        TcpPort.open(
            numbers
                .listening("Dashboard", STANDARD_PORT)
                .readBy(() -> new LineDissector(DashboardServer::effect)),
            connection ->
                new DashboardSession(
                    connection, dashboardHandler, serverContext.remote().mayControl()),
            serverContext.log());
    return new DashboardServer(port);
  }

  private static Optional<String> effect(String line) {
    return DashboardRequest.read(line)
        .filter(each -> each.word().acts() || each.word().shows())
        .map(each -> line.strip());
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
