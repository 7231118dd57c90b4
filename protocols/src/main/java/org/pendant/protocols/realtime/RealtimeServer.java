package org.pendant.protocols.realtime;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.ScriptDesk;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.Server;

/** Port 30003, which takes scripts, and its read-only twin 30013. */
public final class RealtimeServer implements Server {
  private static final int REALTIME = 30003;
  private static final int REALTIME_READ_ONLY = 30013;

  private final Outside outside;
  private final RealtimeCodec codec = new RealtimeCodec();
  private final List<Connection> clients = new CopyOnWriteArrayList<>();
  private final Consumer<ControllerState> frames = this::send;
  private final TcpPort writable;
  private final TcpPort readOnly;

  private RealtimeServer(Outside outside, PortNumbers numbers, ScriptDesk desk) throws IOException {
    this.outside = outside;
    writable = listen(numbers, "Realtime", REALTIME, desk::session);
    try {
      readOnly =
          listen(
              numbers,
              "Realtime read-only",
              REALTIME_READ_ONLY,
              (connection, left) -> ScriptDesk.readOnly(left));
    } catch (IOException e) {
      writable.close();
      throw e;
    }
  }

  /**
   * Opens both ports.
   *
   * @param desk runs what clients send
   * @throws IOException if a port cannot be had; the message names it, and none is open then
   */
  public static RealtimeServer open(Outside outside, PortNumbers numbers, ScriptDesk desk)
      throws IOException {
    RealtimeServer server = new RealtimeServer(outside, numbers, desk);
    outside.frames().add(server.frames);
    outside.remote().onLocal(server.writable::disconnectAll);
    return server;
  }

  private TcpPort listen(
      PortNumbers numbers, String name, int number, BiFunction<Connection, Runnable, Session> input)
      throws IOException {
    return TcpPort.open(
        numbers.listening(name, number),
        connection -> {
          clients.add(connection);
          return input.apply(connection, () -> clients.remove(connection));
        },
        outside.log());
  }

  private void send(ControllerState state) {
    if (clients.isEmpty()) {
      return;
    }
    byte[] bytes = codec.encode(state);
    for (Connection client : clients) {
      client.stream(bytes);
    }
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(writable, readOnly);
  }

  @Override
  public void close() {
    outside.frames().remove(frames);
    Server.super.close();
  }
}
