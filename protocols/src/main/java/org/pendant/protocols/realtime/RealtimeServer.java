package org.pendant.protocols.realtime;

import static org.pendant.protocols.realtime.RealtimeTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.Protocol;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.PortOpening;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/** Real-time server: port 30003, which takes scripts, and its read-only twin 30013. */
public final class RealtimeServer implements Server {
  /** Where it listens on a real box. */
  public static final int REALTIME = 30003;

  private static final int REALTIME_READ_ONLY = 30013;

  private final ServerContext serverContext;
  private final RealtimeCodec codec = new RealtimeCodec();
  private final List<Connection> clients = new CopyOnWriteArrayList<>();
  private final Consumer<ControllerState> frames = this::send;
  private final List<TcpPort> writable = new ArrayList<>();
  private final List<TcpPort> readOnly = new ArrayList<>();
  private final PortOpening opening = new PortOpening();

  private RealtimeServer(ServerContext serverContext) {
    this.serverContext = serverContext;
  }

  /**
   * Opens those of the two ports that can be had.
   *
   * @param scriptHandler runs what clients send
   */
  public static RealtimeServer open(
      ServerContext serverContext, PortNumbers numbers, ScriptHandler scriptHandler) {
    RealtimeServer server = new RealtimeServer(serverContext);
    server.listen(
        numbers.listening("Realtime", REALTIME).readBy(() -> new RealtimeDissector(true)),
        REALTIME,
        scriptHandler::session,
        server.writable);
    server.listen(
        numbers
            .listening(text("readOnlyPort"), REALTIME_READ_ONLY)
            .readBy(() -> new RealtimeDissector(false)),
        REALTIME_READ_ONLY,
        (connection, left) -> ScriptHandler.readOnly(left),
        server.readOnly);
    serverContext.frames().add(server.frames);
    serverContext.remote().onLocal(() -> server.writable.forEach(TcpPort::disconnectAll));
    return server;
  }

  private void listen(
      Listening listening,
      int number,
      BiFunction<Connection, Runnable, Session> input,
      List<TcpPort> ports) {
    Protocol protocol =
        connection -> {
          clients.add(connection);
          return input.apply(connection, () -> clients.remove(connection));
        };
    opening.attempt(
        number, () -> ports.add(TcpPort.open(listening, protocol, serverContext.log())));
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
    return Stream.concat(writable.stream(), readOnly.stream()).toList();
  }

  @Override
  public List<MissingPort> missing() {
    return opening.missing();
  }

  @Override
  public void close() {
    serverContext.frames().remove(frames);
    Server.super.close();
  }
}
