package org.pendant.protocols.device;

import static org.pendant.protocols.device.DeviceServerTexts.text;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.pendant.controller.device.DeviceState;
import org.pendant.protocols.http.HttpDissector;
import org.pendant.protocols.http.HttpSession;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/** Procedure server: the port of devices of the cell whose procedures are called by XML-RPC. */
public final class ProcedureServer implements Server {
  private static final Duration IDLE = Duration.ofMinutes(5);

  private final TcpPort port;

  private ProcedureServer(TcpPort port) {
    this.port = port;
  }

  /** The ports of such devices; several devices may serve one. */
  public static List<Integer> wanted(ServerContext serverContext) {
    return serverContext.robot().state().devices().stream()
        .map(DeviceState::procedurePort)
        .filter(each -> each > 0)
        .distinct()
        .toList();
  }

  /**
   * Begins to listen.
   *
   * @param number the port at which programs reach the devices
   * @throws IOException if the port cannot be had
   */
  public static ProcedureServer open(ServerContext serverContext, PortNumbers numbers, int number)
      throws IOException {
    ProcedureCalls calls = new ProcedureCalls(serverContext.robot(), number);
    return new ProcedureServer(
        TcpPort.open(
            DeviceServer.listening(numbers, text("proceduresPort"), number)
                .with(IdleLimits.of(IDLE))
                .readBy(HttpDissector::new),
            connection -> new HttpSession(connection, calls),
            serverContext.log()));
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
