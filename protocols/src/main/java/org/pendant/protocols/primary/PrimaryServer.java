package org.pendant.protocols.primary;

import static org.pendant.protocols.primary.PrimaryTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.Protocol;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.PortOpening;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/**
 * Primary server: ports 30001 and 30002, which take scripts, and their read-only twins 30011 and
 * 30012.
 */
public final class PrimaryServer implements Server {
  /** Where most clients send their scripts. */
  public static final int PRIMARY = 30001;

  /** Where clients find the same without the messages of the primary port. */
  public static final int SECONDARY = 30002;

  private static final int PRIMARY_READ_ONLY = 30011;
  private static final int SECONDARY_READ_ONLY = 30012;

  private final ServerContext serverContext;
  private final PrimaryFeed feed;
  private final Consumer<ControllerState> frames;
  private final List<TcpPort> writable = new ArrayList<>();
  private final List<TcpPort> readOnly = new ArrayList<>();
  private final PortOpening opening = new PortOpening();

  private PrimaryServer(ServerContext serverContext, PrimaryFeed feed) {
    this.serverContext = serverContext;
    this.feed = feed;
    frames = feed::frame;
  }

  /**
   * Opens those of the four ports that can be had.
   *
   * @param scriptHandler runs what clients send
   */
  public static PrimaryServer open(
      ServerContext serverContext, PortNumbers numbers, ScriptHandler scriptHandler) {
    PrimaryFeed feed = new PrimaryFeed(serverContext.robot());
    PrimaryServer server = new PrimaryServer(serverContext, feed);
    server.take(numbers, "Primary", PRIMARY, feed::addPrimary, scriptHandler);
    server.take(numbers, "Secondary", SECONDARY, feed::addSecondary, scriptHandler);
    server.showOnly(numbers, text("primaryReadOnly"), PRIMARY_READ_ONLY, feed::addPrimary);
    server.showOnly(numbers, text("secondaryReadOnly"), SECONDARY_READ_ONLY, feed::addSecondary);
    serverContext.frames().add(server.frames);
    scriptHandler.onTrouble(feed::tell);
    serverContext.remote().onLocal(() -> server.writable.forEach(TcpPort::disconnectAll));
    return server;
  }

  private void take(
      PortNumbers numbers,
      String name,
      int number,
      Consumer<Connection> greeting,
      ScriptHandler scriptHandler) {
    Protocol protocol =
        connection -> {
          greeting.accept(connection);
          return scriptHandler.session(connection, () -> feed.remove(connection));
        };
    Listening listening = numbers.listening(name, number).readBy(() -> new PrimaryDissector(true));
    listen(listening, number, protocol, writable);
  }

  private void showOnly(
      PortNumbers numbers, String name, int number, Consumer<Connection> greeting) {
    Protocol protocol =
        connection -> {
          greeting.accept(connection);
          return ScriptHandler.readOnly(() -> feed.remove(connection));
        };
    Listening listening = numbers.listening(name, number).readBy(() -> new PrimaryDissector(false));
    listen(listening, number, protocol, readOnly);
  }

  private void listen(Listening listening, int number, Protocol protocol, List<TcpPort> ports) {
    opening.attempt(
        number, () -> ports.add(TcpPort.open(listening, protocol, serverContext.log())));
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
