package org.pendant.protocols.device;

import static org.pendant.protocols.device.DeviceServerTexts.text;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.pendant.controller.device.DeviceState;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.toolserial.ToolSerialServer;

/** Device server: the port of a device of the cell, as the driver of a real one opens it. */
public final class DeviceServer implements Server {
  private static final int MAX_PORT = 65_535;

  private final TcpPort port;

  private DeviceServer(TcpPort port) {
    this.port = port;
  }

  /** The devices that programs on other computers reach at a port. */
  public static List<DeviceState> wanted(ServerContext serverContext) {
    return serverContext.robot().state().devices().stream()
        .filter(each -> each.port() > 0 && each.port() != ToolSerialServer.STANDARD_PORT)
        .toList();
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static DeviceServer open(
      ServerContext serverContext, PortNumbers numbers, DeviceState device) throws IOException {
    String kind = device.kind();
    Listening listening =
        listening(
            numbers,
            kind.substring(0, 1).toUpperCase(Locale.ROOT) + kind.substring(1),
            device.port());
    AtomicLong connections = new AtomicLong();
    return new DeviceServer(
        TcpPort.open(
            listening,
            connection ->
                new DeviceSession(
                    connection,
                    serverContext.robot(),
                    device.port(),
                    connections.incrementAndGet()),
            serverContext.log()));
  }

  /**
   * How a device listens.
   *
   * @param name of the port
   * @throws IOException if the offset of ports leaves no room for it
   */
  static Listening listening(PortNumbers numbers, String name, int port) throws IOException {
    Listening listening = numbers.listening(name, port);
    if (listening.port() > MAX_PORT) {
      throw new IOException(
          text("portBeyondLast", name, listening.port(), MAX_PORT, MAX_PORT - port));
    }
    return listening;
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
