package org.pendant.protocols.robotapi;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.pendant.protocols.http.HttpDissector;
import org.pendant.protocols.http.HttpSession;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.RemotePendant;

/** Robot API server of a control box with PolyScope X. */
public final class RobotApiServer implements Server {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 80;

  /** Clients ask at once; who wants something later connects again. */
  private static final Duration IDLE = Duration.ofSeconds(30);

  private final TcpPort port;

  private RobotApiServer(TcpPort port) {
    this.port = port;
  }

  /**
   * Begins to listen.
   *
   * @param remotePendant works the box for the clients
   * @throws IOException if the port cannot be had
   */
  public static RobotApiServer open(
      ServerContext serverContext, PortNumbers numbers, RemotePendant remotePendant)
      throws IOException {
    RobotApi api =
        new RobotApi(
            new RobotApiHandler(remotePendant, serverContext.remote()),
            new ProgramTransfers(remotePendant.store()),
            serverContext.remote());
    return new RobotApiServer(
        TcpPort.open(
            numbers
                .listening("Robot API", STANDARD_PORT)
                .with(IdleLimits.of(IDLE))
                .readBy(HttpDissector::new),
            connection -> new HttpSession(connection, api),
            serverContext.log()));
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
