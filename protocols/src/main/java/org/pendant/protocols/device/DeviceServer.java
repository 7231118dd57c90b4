package org.pendant.protocols.device;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/** Device server: the port of a device of the cell, as the driver of a real one opens it. */
public final class DeviceServer implements Server {
  /** The port of the driver of a two-finger gripper. */
  public static final int TWO_FINGER_PORT = 63_352;

  private static final int MAX_PORT = 65_535;

  private final TcpPort port;

  private DeviceServer(TcpPort port) {
    this.port = port;
  }

  /** Whether the cell has a device for it. */
  public static boolean wanted(ServerContext serverContext) {
    return serverContext.robot().state().devices().stream()
        .anyMatch(each -> each.port() == TWO_FINGER_PORT);
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static DeviceServer open(ServerContext serverContext, PortNumbers numbers)
      throws IOException {
    Listening listening = numbers.listening("Two-finger gripper", TWO_FINGER_PORT);
    if (listening.port() > MAX_PORT) {
      throw new IOException(
          "the two-finger gripper would listen at port "
              + listening.port()
              + ", must be at most "
              + MAX_PORT
              + ": an offset of "
              + (MAX_PORT - TWO_FINGER_PORT)
              + " leaves room");
    }
    AtomicLong connections = new AtomicLong();
    return new DeviceServer(
        TcpPort.open(
            listening,
            connection ->
                new DeviceSession(
                    connection,
                    serverContext.robot(),
                    TWO_FINGER_PORT,
                    connections.incrementAndGet()),
            serverContext.log()));
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
