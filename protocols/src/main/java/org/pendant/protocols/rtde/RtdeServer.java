package org.pendant.protocols.rtde;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Semaphore;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/**
 * RTDE server: the real-time data exchange of a control box. Local control does not keep clients
 * from writing: what they reach are inputs and outputs, not commands.
 */
public final class RtdeServer implements Server {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 30004;

  private final TcpPort port;

  private RtdeServer(TcpPort port) {
    this.port = port;
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static RtdeServer open(ServerContext serverContext, PortNumbers numbers)
      throws IOException {
    Listening listening =
        numbers
            .listening("RTDE", STANDARD_PORT)
            .with(IdleLimits.peerBegins())
            .readBy(RtdeTerms.NONE::dissector);
    Semaphore inputRoom = new Semaphore(InputHandler.MAX_OF_ALL);
    return new RtdeServer(
        TcpPort.open(
            listening,
            connection -> new RtdeSession(connection, serverContext, inputRoom),
            serverContext.log()));
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
