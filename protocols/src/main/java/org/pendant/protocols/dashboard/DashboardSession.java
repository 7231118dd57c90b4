package org.pendant.protocols.dashboard;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.LineCutter;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** Dashboard session: one client, with an answer to every line, in their order. */
final class DashboardSession implements Session {
  private static final int MAX_LINE = 1 << 16;
  private static final String GREETING = "Connected: Universal Robots Dashboard Server";
  private static final String LOCAL =
      "Command is not allowed due to safety reasons, please switch robot to Remote Control mode"
          + " and reconnect to port 29999";

  private final Connection connection;
  private final DashboardHandler dashboardHandler;
  private final boolean mayControl;
  private final LineCutter lines = new LineCutter(MAX_LINE);
  private boolean left;

  /**
   * Greets the client.
   *
   * @param mayControl whether it may do more than ask, as long as it stays connected
   */
  DashboardSession(Connection connection, DashboardHandler dashboardHandler, boolean mayControl) {
    this.connection = connection;
    this.dashboardHandler = dashboardHandler;
    this.mayControl = mayControl;
    send(GREETING);
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    for (String line : lines.take(bytes)) {
      if (!left) {
        answer(line);
      }
    }
  }

  private void answer(String line) {
    Optional<DashboardRequest> request = DashboardRequest.read(line);
    if (request.isEmpty()) {
      send("could not understand: '" + line.strip() + "'");
    } else if (request.get().word().acts() && !mayControl) {
      send(LOCAL);
    } else {
      send(dashboardHandler.answer(request.get()));
      if (request.get().word() == DashboardCommand.QUIT) {
        left = true;
        connection.closeAfterSending();
      }
    }
  }

  private void send(String line) {
    connection.send((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
  }
}
