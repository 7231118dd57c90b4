package org.pendant.protocols.dashboard;

import java.io.IOException;
import java.util.List;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.Server;

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
   * @param panel works the box for the clients
   * @throws IOException if the port cannot be had
   */
  public static DashboardServer open(Outside outside, PortNumbers numbers, Panel panel)
      throws IOException {
    DashboardDesk desk = new DashboardDesk(panel, outside.remote(), outside.log());
    TcpPort port =
        TcpPort.open(
            numbers.listening("Dashboard", STANDARD_PORT),
            connection -> new DashboardSession(connection, desk, outside.remote().mayControl()),
            outside.log());
    return new DashboardServer(port);
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
